// Tar files (POSIX ustar) with the same bytes each time: no times, no owners. Their members are grouped by the name up
// to the first dot, as WebDataset reads them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace tumble::sweep {

// A member: its header, its bytes and its padding. The name has at most 100 bytes. Throws std::invalid_argument.
std::string tar_member(std::string_view name, std::string_view bytes);

// The end of a tar file of `size` bytes so far.
std::string tar_end(std::uint64_t size);

}  // namespace tumble::sweep
