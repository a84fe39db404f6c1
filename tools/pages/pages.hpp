// The texts of the files that an installation has besides the binary: its manual page and the completions of shells.
#pragma once

#include <string>
#include <vector>

#include "tools/pages/option_list.hpp"

namespace tumble::tools {

// tumble(1), for man.
std::string manual_page(const std::vector<ListedCommand>& commands, const std::string& version);

std::string bash_completion(const std::vector<ListedCommand>& commands);
std::string zsh_completion(const std::vector<ListedCommand>& commands);
std::string fish_completion(const std::vector<ListedCommand>& commands);

}  // namespace tumble::tools
