// Cortex-A9 out of reset: one core, Arm state, supervisor mode. Each mode that a fault enters has the
// handlers' stack.
  .syntax unified
  .arm
  .section .vectors, "ax"
  .balign 32
vectors:
  b reset_handler
  b undefined
  b unexpected
  b prefetch_abort
  b data_abort
  b unexpected
  b unexpected
  b unexpected

  .global reset_handler
  .type reset_handler, %function
reset_handler:
  ldr r0, =vectors
  mcr p15, 0, r0, c12, c0, 0 // VBAR
  ldr r0, =handler_stack_top
  cps #0x17 // abort
  mov sp, r0
  cps #0x1B // undefined
  mov sp, r0
  cps #0x12 // IRQ
  mov sp, r0
  cps #0x11 // FIQ
  mov sp, r0
  cps #0x13 // supervisor
  ldr sp, =stack_top
  blx spangle_start

undefined:
  sub r0, lr, #4
  mov r1, #0
  blx spangle_fault
prefetch_abort:
  sub r0, lr, #4
  mov r1, #1
  blx spangle_fault
data_abort:
  sub r0, lr, #8
  mov r1, #2
  blx spangle_fault
unexpected:
  blx spangle_unexpected
