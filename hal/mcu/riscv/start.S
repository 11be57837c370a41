// RISC-V out of reset: one hart, machine mode. A trap has a stack of its own; where RAM has neighbours,
// physical memory protection closes the stack_guard bytes below the stack, even for machine mode.
  .option arch, +zicsr
  .section .vectors, "ax"
  .global reset_handler
reset_handler:
  .option push
  .option norelax
  la gp, __global_pointer$
  .option pop
  la t0, trap
  csrw mtvec, t0
  la sp, stack_top
  lui t0, %hi(stack_guard)
  addi t0, t0, %lo(stack_guard)
  beqz t0, 1f
  la t1, stack_bottom
  sub t1, t1, t0   // a power of two, at a multiple of itself: NAPOT
  srli t1, t1, 2
  srli t0, t0, 3
  addi t0, t0, -1
  or t1, t1, t0
  csrw pmpaddr0, t1
  li t0, 0x98      // locked, NAPOT, no access
  csrw pmpcfg0, t0
1:
  call spangle_start

  .balign 4
trap:
  la sp, handler_stack_top
  csrr a0, mcause
  csrr a1, mepc
  csrr a2, mtval
  call spangle_trap
