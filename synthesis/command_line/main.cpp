#include <signal.h>
#include <sys/mman.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <new>
#include <string_view>

#include "synthesis/command_line/exit_code.h"
#include "synthesis/command_line/run.h"
#include "synthesis/program/number_memory.h"

namespace {

/// Says so without needing any.
[[noreturn]] void end_without_memory() {
    constexpr std::string_view message = "mechwright: out of memory\n";
    const auto written = ::write(STDERR_FILENO, message.data(), message.size());
    static_cast<void>(written);
    ::_exit(mechwright::exit_code::internal_error);
}

/// What no handler can catch: the JSON library needs memory to give memory back, in destructors. Without an exception
/// the runtime had no room for one, and none for looking at it where it comes here a second time.
[[noreturn]] void on_terminate() {
    static std::atomic_flag looked = ATOMIC_FLAG_INIT;
    const bool again = looked.test_and_set();
    try {
        const auto thrown = std::current_exception();
        if (!thrown || again) end_without_memory();
        std::rethrow_exception(thrown);
    } catch (const std::bad_alloc&) {
        end_without_memory();
    } catch (...) {
    }
    std::abort();
}

/// Several times what the main thread needs of its stack.
constexpr std::size_t stack_needed = 2 << 20;

[[gnu::noinline]] void touch_stack() {
    [[maybe_unused]] volatile char block[stack_needed];
    constexpr std::size_t page = 4096;
    for (std::size_t i = stack_needed; i >= page; i -= page)
        block[i - page] = 0;
}

/// The system lets the stack grow as it is used, and where memory is limited ends the program by a signal then. It is
/// made to grow now, once it is known that there is room.
void take_stack() {
    void* room = ::mmap(nullptr, stack_needed, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (room == MAP_FAILED) end_without_memory();
    ::munmap(room, stack_needed);
    touch_stack();
}

}  // namespace

int main(int argc, char** argv) {
    std::set_terminate(on_terminate);
    take_stack();
    mechwright::throw_where_numbers_get_no_memory();
    // A closed pipe and a full file are errors of writing, not the end of the program.
    ::signal(SIGPIPE, SIG_IGN);
    ::signal(SIGXFSZ, SIG_IGN);
    mechwright::Console console{std::cout, std::cerr, ::isatty(STDOUT_FILENO) == 1, ::isatty(STDERR_FILENO) == 1};
    return mechwright::run(argc, argv, console);
}
