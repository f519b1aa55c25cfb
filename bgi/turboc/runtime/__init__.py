"""What a C program meets while it runs: memory, and C's library on the functions of this one."""
