// JSON pointers (RFC 6901).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tumble::scene {

// The location of a value: a key or index, linked to the location of the container. The links live on the stack of the
// reader, so that no pointer text is built until an error needs it.
struct Location {
    const Location* parent = nullptr;
    std::string_view key;   // of an object, or
    std::size_t index = 0;  // of an array, if key.data() is null
};

inline Location child(const Location& parent, std::string_view key) { return {&parent, key, 0}; }
inline Location child(const Location& parent, std::size_t index) { return {&parent, {}, index}; }

// "" for the root, "/bodies/3/name"; ~ and / in keys are escaped as ~0 and ~1.
std::string pointer_to(const Location& location);

// `pointer` with one more step.
std::string append_key(const std::string& pointer, std::string_view key);

// The unescaped steps of a pointer. It must be empty or start with '/'.
std::vector<std::string> split_pointer(std::string_view pointer);

// True if `pointer` is `ancestor` or a pointer below it.
bool is_within(std::string_view pointer, std::string_view ancestor);

}  // namespace tumble::scene
