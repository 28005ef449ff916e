// For the leak sanitizer, which asks every program for this function: CLN keeps a few bytes of its own tables until
// the program ends. Linked into the project's programs in sanitizer builds only.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libcln\nleak:libginac\n";
}
// What is suppressed would be printed among a program's own messages.
extern "C" const char* __lsan_default_options();
extern "C" const char* __lsan_default_options() {
  return "print_suppressions=0";
}
