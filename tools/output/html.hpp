// Writes HTML reports: self-contained documents with headings, text, tables and drawings. Text is escaped, and the page
// loads no external resources.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tumble/drawing.hpp"

namespace tumble::tools {

struct HtmlCell {
    std::string text;
    bool is_number = false;  // aligned to the right
    bool is_alarm = false;   // drawn in red
};

class HtmlPage {
public:
    explicit HtmlPage(std::string_view title);

    void heading(std::string_view text);
    void paragraph(std::string_view text);
    void table(std::span<const std::string> header, std::span<const std::vector<HtmlCell>> rows);
    void figure(const Drawing& drawing, std::string_view caption);
    void preformatted(std::string_view text);

    // Everything between the two calls is collapsed under the summary until the reader opens it.
    void begin_details(std::string_view summary);
    void end_details();

    std::string str() const;  // the whole document

private:
    std::string title_;
    std::string body_;
};

}  // namespace tumble::tools
