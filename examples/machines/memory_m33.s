@ mps2-an505: as much as on the other boards, in memory that the core may use in its secure state, in which it starts.
.globl _flash_origin, _flash_length, _ram_origin, _ram_length
.set _flash_origin, 0x10000000
.set _flash_length, 256 * 1024
.set _ram_origin,   0x38000000
.set _ram_length,   16 * 1024
