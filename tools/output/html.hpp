// Writes HTML reports: self-contained documents with headings, text, tables, plots and drawings, in light or dark
// colours as the reader's browser prefers. Text is escaped, and the page loads no external resources.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tools/output/plot.hpp"
#include "tumble/drawing.hpp"
#include "tumble/render.hpp"

namespace tumble::tools {

struct HtmlCell {
    std::string text;
    bool is_number = false;  // aligned to the right
    bool is_alarm = false;   // drawn in red
    bool is_good = false;    // drawn in green
};

class HtmlPage {
public:
    explicit HtmlPage(std::string_view title);

    void heading(std::string_view text);
    void paragraph(std::string_view text);
    void table(std::span<const std::string> header, std::span<const std::vector<HtmlCell>> rows);
    void figure(const Drawing& drawing, std::string_view caption);
    void figure(const Plot& plot, std::string_view caption = {});
    void picture(const Image& image, std::string_view caption);                       // inside the page, as PNG
    void linked_picture(std::string_view file, int width, std::string_view caption);  // in a file beside the page
    void embedded(std::string_view title, std::string_view page, int height);         // a whole page in a frame, px
    void preformatted(std::string_view text);

    // The figures between the two calls stand side by side where there is room.
    void begin_figures();
    void end_figures();

    // Everything between the two calls is collapsed under the summary until the reader opens it.
    void begin_details(std::string_view summary);
    void end_details();

    std::string str() const;  // the whole document

private:
    std::string title_;
    std::string body_;
};

}  // namespace tumble::tools
