// What counting a call takes by itself, which is no part of any command.
extern "C" void measure_nothing() {}
