#if NET
// The compiler ensures that nothing is read before it is written, so the runtime need not clear the locals of a method. It would clear
// a Wrench by one store of 64 bytes, and an addition to 8 of them waits for that store: a tenth of the lab's step.
[module: System.Runtime.CompilerServices.SkipLocalsInit]
#endif
