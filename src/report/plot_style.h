// What all figures have in common: gnuplot's settings, panels in rows, colours.
#pragma once

#include <string>
#include <vector>

namespace gnomon::report {

/// Panels in rows, each with a title; sizes in pixels.
struct Layout {
    size_t panels;
    int columns, rows;
    double width = 264, height = 190;                     ///< of a panel's inside
    double left = 72, right = 16, bottom = 42, top = 28;  ///< around it
    double above = 34, below = 12, beside = 0;            ///< around all of them

    double whole_width() const { return columns * (left + width + right) + beside; }
    double whole_height() const { return above + rows * (top + height + bottom) + below; }
};
Layout layout_for(size_t panels);

/// Terminal, fonts, axes.
std::string head(const Layout& layout);
/// Places the panel with this number; its title, and the titles of the axes where nothing else is beside or below it.
std::string begin_panel(const Layout& layout, size_t panel, const std::string& title, const std::string& x_title,
                        const std::string& y_title);

/// Of a formula or an accuracy: Okabe and Ito's colours, told apart by the colour-blind too, and a shape of its own.
struct Mark {
    std::string color;
    int shape;  ///< gnuplot's point type, filled
};
Mark mark_of(const std::string& name);

/// Names with their marks in a row above all panels.
std::string key(const Layout& layout, const std::vector<std::string>& names);

/// In double quotes for gnuplot, nothing in it with a meaning of its own.
std::string quoted(const std::string& text);

}  // namespace gnomon::report
