@ 256 KiB of code memory and 16 KiB of RAM: what microbit has, the smallest of the emulated boards, and where it has
@ them. The boards with a Cortex-M3, M4 and M7 have more in the same places.
.globl _flash_origin, _flash_length, _ram_origin, _ram_length
.set _flash_origin, 0x00000000
.set _flash_length, 256 * 1024
.set _ram_origin,   0x20000000
.set _ram_length,   16 * 1024
