#include "plot_style.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>

namespace gnomon::report {

Layout layout_for(size_t panels) {
    const int columns = std::clamp(static_cast<int>(panels), 1, 3);
    return {panels, columns, (static_cast<int>(panels) + columns - 1) / columns};
}

std::string head(const Layout& l) {
    return fmt::format(
        "set encoding utf8\n"
        "set terminal svg enhanced size {:.0f},{:.0f} dynamic font 'Helvetica,Arial,sans-serif,12' linewidth 1 "
        "background '#ffffff'\n"
        "set output 'out.svg'\n"
        "set border 3 linecolor '#555555'\n"
        "set tics nomirror out scale 0.5,0.25 textcolor '#333333'\n"
        "set grid linecolor '#e4e4e4' linewidth 0.7\n"
        "unset key\n"
        "set multiplot\n",
        l.whole_width(), l.whole_height());
}

std::string begin_panel(const Layout& l, size_t panel, const std::string& title, const std::string& x_title,
                        const std::string& y_title) {
    const auto columns = static_cast<size_t>(l.columns);
    const auto column = static_cast<double>(panel % columns), row = static_cast<double>(panel / columns);
    const double x = column * (l.left + l.width + l.right) + l.left;
    const double y = l.whole_height() - l.above - row * (l.top + l.height + l.bottom) - l.top;
    const double w = l.whole_width(), h = l.whole_height();
    std::string text = fmt::format("set lmargin at screen {}\nset rmargin at screen {}\n", x / w, (x + l.width) / w);
    text += fmt::format("set tmargin at screen {}\nset bmargin at screen {}\n", y / h, (y - l.height) / h);
    text += "set title " + quoted(title) + " noenhanced offset 0,-0.5 font ',13'\n";
    const bool is_lowest = panel + columns >= l.panels;
    text += "set xlabel " + quoted(is_lowest ? x_title : "") + " noenhanced offset 0,0.3\n";
    return text + "set ylabel " + quoted(column == 0 ? y_title : "") + " noenhanced offset 0.8,0\n";
}

Mark mark_of(const std::string& name) {
    static const std::map<std::string, Mark> marks = {{"textbook", {"#D55E00", 5}}, {"perpendicular", {"#E69F00", 9}},
                                                      {"pencil", {"#0072B2", 7}},   {"compensated", {"#009E73", 13}},
                                                      {"double", {"#CC79A7", 11}},  {"certified", {"#56B4E9", 15}},
                                                      {"strict", {"#0072B2", 7}},   {"fast", {"#D55E00", 5}}};
    const auto found = marks.find(name);
    return found == marks.end() ? Mark{"#000000", 7} : found->second;
}

std::string key(const Layout& l, const std::vector<std::string>& names) {
    std::string text;
    double x = l.left;
    for (const std::string& name : names) {
        const Mark mark = mark_of(name);
        text += fmt::format(
            "set label {} at screen {},{} left front noenhanced point pt {} ps 0.8 lc rgb '{}' offset 0.8,0\n",
            quoted(name), x / l.whole_width(), 1 - 14 / l.whole_height(), mark.shape, mark.color);
        x += 40 + 7 * static_cast<double>(name.size());
    }
    return text;
}

std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\' || c == '`' || c == '$' || c == '@') result += '\\';
        if (static_cast<unsigned char>(c) >= ' ') result += c;
    }
    return result + "\"";
}

}  // namespace gnomon::report
