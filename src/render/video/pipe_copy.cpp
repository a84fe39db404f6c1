#include "render/video/pipe_copy.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <string_view>
#include <system_error>
#include <utility>

namespace tumble::render {

PipeCopy::PipeCopy(OutputFile& file) : file_(file) {
    std::array<int, 2> ends{-1, -1};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0)
        throw FileError(file.path(), "cannot make a pipe: " + std::generic_category().message(errno));
    entry_ = ends[1];
    thread_ = std::thread([this, exit = ends[0]] { copy(exit); });
}

PipeCopy::~PipeCopy() {
    close_entry();
    if (thread_.joinable()) thread_.join();
}

void PipeCopy::close_entry() {
    if (entry_ >= 0) ::close(std::exchange(entry_, -1));
}

void PipeCopy::finish() {
    close_entry();
    if (thread_.joinable()) thread_.join();
    if (error_) std::rethrow_exception(error_);
}

void PipeCopy::copy(int exit) {
    std::array<char, 1 << 16> block;
    try {
        for (ssize_t size = 1; size != 0;) {
            size = ::read(exit, block.data(), block.size());
            if (size < 0 && errno != EINTR)
                throw FileError(file_.path(), "cannot read a pipe: " + std::generic_category().message(errno));
            if (size <= 0) continue;
            file_.write(std::string_view(block.data(), static_cast<std::size_t>(size)));
            file_.save_so_far();
        }
    } catch (...) {
        error_ = std::current_exception();
    }
    ::close(exit);
}

}  // namespace tumble::render
