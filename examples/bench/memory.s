@ mps2-an386: 4 MiB of code memory, 4 MiB of RAM, in place of memory.x's numbers.
.globl _flash_origin, _flash_length, _ram_origin, _ram_length
.set _flash_origin, 0x00000000
.set _flash_length, 4 * 1024 * 1024
.set _ram_origin,   0x20000000
.set _ram_length,   4 * 1024 * 1024
