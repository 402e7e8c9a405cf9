#pragma once

#include <string>

/// What is done with the terminal when the program crashes; all of it may be done inside a signal handler.
namespace rift::studio {

/// Keeps the terminal's modes as they are now, before anybody changes them.
void keep_modes();

/// From now on SIGSEGV, SIGBUS, SIGFPE, SIGILL and SIGABRT first write `restore` to the terminal and set its
/// modes as they were kept, then say what happened, then end the program as they would have.
/// @param restore  control codes; at most 200 bytes
void guard_terminal(const std::string& restore);

/// Signals are as they were.
void unguard_terminal();

/// What to say beside the signal's number; at most 400 bytes are kept.
void say_in_a_crash(const std::string& text);

}  // namespace rift::studio
