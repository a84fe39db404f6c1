// Escaping follows RFC 6901, section 3.
#include "scene/json/pointer.hpp"

namespace tumble::scene {

std::string append_key(const std::string& pointer, std::string_view key) {
    std::string result = pointer + '/';
    for (const char c : key) {
        if (c == '~') {
            result += "~0";
        } else if (c == '/') {
            result += "~1";
        } else {
            result += c;
        }
    }
    return result;
}

std::string pointer_to(const Location& location) {
    if (location.parent == nullptr) return {};
    const std::string start = pointer_to(*location.parent);
    return location.key.data() == nullptr ? start + '/' + std::to_string(location.index)
                                          : append_key(start, location.key);
}

std::vector<std::string> split_pointer(std::string_view pointer) {
    std::vector<std::string> steps;
    for (std::size_t i = 0; i < pointer.size(); ++i) {
        if (pointer[i] == '/') {
            steps.emplace_back();
        } else if (pointer[i] == '~' && i + 1 < pointer.size() && (pointer[i + 1] == '0' || pointer[i + 1] == '1')) {
            steps.back() += pointer[++i] == '0' ? '~' : '/';
        } else {
            steps.back() += pointer[i];
        }
    }
    return steps;
}

bool is_within(std::string_view pointer, std::string_view ancestor) {
    return pointer.starts_with(ancestor) && (pointer.size() == ancestor.size() || pointer[ancestor.size()] == '/');
}

}  // namespace tumble::scene
