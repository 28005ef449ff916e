// Linked into the project's programs in sanitizer builds only.
//
// What CLN's tables keep until the program ends is no leak: what libraries allocate before the program's own
// objects are made is not looked at. To suppress it by name instead costs every program a tenth of a second at its
// end, in which addresses become names.
extern "C" void __lsan_disable();
extern "C" void __lsan_enable();

namespace secular {
namespace {

using Initializer = void (*)();
// The loader calls these before the initializers of libraries, which are before the program's own.
[[gnu::section(".preinit_array"), gnu::used]] const Initializer before_libraries = __lsan_disable;
[[gnu::constructor(101)]] void after_libraries() {
  __lsan_enable();
}

}  // namespace
}  // namespace secular

// What they allocate later on. It would be printed among a program's own messages.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libcln\nleak:libginac\n";
}
extern "C" const char* __lsan_default_options();
extern "C" const char* __lsan_default_options() {
  return "print_suppressions=0";
}

// The address sanitizer keeps what is freed, to tell when it is used again: up to 256 MB by default, whose pages
// cost the system more time than a diagnosis of one decay costs otherwise. The last 32 MB hold what is freed within
// a step.
extern "C" const char* __asan_default_options();
extern "C" const char* __asan_default_options() {
  return "quarantine_size_mb=32";
}
