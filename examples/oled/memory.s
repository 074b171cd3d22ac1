@ lm3s6965evb: 256 KiB of flash, 64 KiB of RAM, in place of memory.x's numbers.
.globl _flash_origin, _flash_length, _ram_origin, _ram_length
.set _flash_origin, 0x00000000
.set _flash_length, 256 * 1024
.set _ram_origin,   0x20000000
.set _ram_length,   64 * 1024
