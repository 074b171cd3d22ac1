//! A display's bus with DMA, played by a thread.

use std::sync::mpsc::{Receiver, Sender, channel};
use std::thread::{JoinHandle, spawn};

type Buffer = &'static mut [u8; 480];

/// A bus that sends one buffer at a time.
pub struct Bus {
    out: Sender<Buffer>,
    back: Receiver<Buffer>,
    display: JoinHandle<Vec<u8>>,
}

impl Bus {
    pub fn new() -> Self {
        let (out, arrive) = channel::<Buffer>();
        let (done, back) = channel();
        let display = spawn(move || {
            let mut bytes = Vec::new();
            for buffer in arrive {
                bytes.extend_from_slice(buffer);
                done.send(buffer).unwrap();
            }
            bytes
        });
        Self { out, back, display }
    }

    /// Starts a transfer.
    pub fn start(&mut self, buffer: Buffer) {
        self.out.send(buffer).unwrap();
    }

    /// Waits for its end.
    pub fn finish(&mut self) -> Buffer {
        self.back.recv().unwrap()
    }

    /// What has arrived at the display.
    pub fn close(self) -> Vec<u8> {
        drop(self.out);
        self.display.join().unwrap()
    }
}
