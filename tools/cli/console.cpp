#include "tools/cli/console.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <system_error>
#include <utility>

#include "tools/cli/printable.hpp"
#include "tumble/file.hpp"

namespace tumble::tools {

namespace {

constexpr std::chrono::milliseconds kRedraw{100};

bool output_is_file = false;
bool is_quiet = false;
int output_error = 0;  // errno of the first write to standard output that failed

bool has_terminal() { return isatty(STDERR_FILENO) == 1; }

void write_raw(std::string_view text, FILE* stream) {
    if (std::fwrite(text.data(), 1, text.size(), stream) != text.size() && stream == stdout && output_error == 0)
        output_error = errno;
}

void report(std::string_view kind, std::string_view color, std::string_view message) {
    const char* no_color = std::getenv("NO_COLOR");
    const bool colored = has_terminal() && (no_color == nullptr || *no_color == '\0');
    std::string line = "tumble: ";
    if (colored) line += color;
    line += kind;
    if (colored) line += "\033[0m";
    write_raw(line + ": " + printable(message) + '\n', stderr);
}

}  // namespace

bool give_output_to_file() { return !std::exchange(output_is_file, true); }

bool has_file_output() { return output_is_file; }

std::string printable(std::string_view text) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto byte = static_cast<unsigned char>(text[i]);
        const auto next = static_cast<unsigned char>(i + 1 < text.size() ? text[i + 1] : 0);
        const bool is_c0 = (byte < ' ' && byte != '\n' && byte != '\t') || byte == 0x7f;
        const bool is_c1 = byte == 0xc2 && next >= 0x80 && next < 0xa0;  // two bytes of UTF-8
        result += is_c0 || is_c1 ? '?' : text[i];
        i += is_c1 ? 1 : 0;
    }
    return result;
}

void write_output(std::string_view text) {
    if (output_is_file) return narrate(text);
    if (isatty(STDOUT_FILENO) == 1) return write_raw(printable(text), stdout);
    write_raw(text, stdout);
}

void write_report(std::string_view text) {
    if (!is_quiet) write_output(text);
}

void be_quiet() { is_quiet = true; }

void finish_output() {
    if (std::fflush(stdout) != 0 && output_error == 0) output_error = errno;
    if (output_error == 0) return;
    throw FileError("standard output", "cannot write: " + std::generic_category().message(output_error));
}

void narrate(std::string_view text) { write_raw(printable(text), stderr); }

void narrate_progress(std::string_view text) {
    if (!is_quiet) narrate(text);
}

void report_error(std::string_view message) { report("error", "\033[1;31m", message); }
void report_warning(std::string_view message) { report("warning", "\033[1;33m", message); }

std::string progress_text(std::string_view units, std::uint64_t done, std::uint64_t total, double seconds) {
    constexpr int kBar = 24;  // columns
    const double share = total > 0 ? std::min(static_cast<double>(done) / static_cast<double>(total), 1.0) : 0.0;
    const int filled = static_cast<int>(share * kBar);
    const double rate = seconds > 0.0 ? static_cast<double>(done) / seconds : 0.0;
    const double left = rate > 0.0 && total > done ? static_cast<double>(total - done) / rate : 0.0;
    const int decimals = rate < 10.0 ? 1 : 0;
    std::array<char, 160> line{};
    std::snprintf(line.data(), line.size(), "[%s%s] %llu of %llu %.*s, %.*f per second, %.0f s left",
                  std::string(static_cast<std::size_t>(filled), '#').c_str(),
                  std::string(static_cast<std::size_t>(kBar - filled), '-').c_str(),
                  static_cast<unsigned long long>(done), static_cast<unsigned long long>(total),
                  static_cast<int>(units.size()), units.data(), decimals, rate, std::ceil(left));
    return line.data();
}

Progress::Progress(std::string_view units, std::uint64_t total)
    : units_(units), total_(total), on_terminal_(has_terminal() && !is_quiet) {}

Progress::~Progress() {
    if (shown_) write_raw("\r\033[K", stderr);
}

void Progress::show(std::uint64_t done) {
    if (!on_terminal_) return;
    const std::lock_guard lock(mutex_);
    const Clock::time_point now = Clock::now();
    if (now < next_) return;
    next_ = now + kRedraw;
    shown_ = true;
    const double seconds = std::chrono::duration<double>(now - start_).count();
    write_raw("\r\033[K" + progress_text(units_, done, total_, seconds), stderr);
}

}  // namespace tumble::tools
