// Libraries that are opened at run time: a program starts without them.
#pragma once

#include <initializer_list>
#include <string>

namespace tumble::render {

class SharedLibrary {
public:
    // Opens the first of these that there is; it stays open. Throws RenderError with all reasons, and the Debian
    // package to install.
    SharedLibrary(std::initializer_list<const char*> names, const std::string& package);

    // Throws RenderError if the library has no such function.
    template <class Function>
    void find(const char* name, Function& function) const {
        function = reinterpret_cast<Function>(find_symbol(name));
    }

private:
    void* find_symbol(const char* name) const;

    void* handle_ = nullptr;
    std::string name_;
};

}  // namespace tumble::render
