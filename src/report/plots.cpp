#include "plots.h"

#include "gnuplot.h"

namespace gnomon::report {

namespace {

void replace_all(std::string& text, const std::string& from, const std::string& to) {
    for (size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
}

/// gnuplot opens a group for whatever it might draw; a third of a figure are groups that stay empty.
void drop_empty_groups(std::string& text) {
    const std::string end = "</g>";
    std::string kept;
    size_t from = 0;
    for (size_t at = text.find("<g "); at != std::string::npos; at = text.find("<g ", at + 1)) {
        const size_t inside = text.find('>', at) + 1, next = text.find_first_not_of(" \t\n", inside);
        if (next == std::string::npos || text.compare(next, end.size(), end) != 0) continue;
        kept += text.substr(from, at - from);
        from = next + end.size();
    }
    text = kept + text.substr(from);
}

}  // namespace

std::string inlined(const std::string& svg, const std::string& prefix) {
    std::string text = svg.substr(svg.find("<svg"));
    for (const std::string quote : {"'", "\""}) {
        replace_all(text, "id=" + quote, "id=" + quote + prefix);
        replace_all(text, "href=" + quote + "#", "href=" + quote + "#" + prefix);
    }
    replace_all(text, "url(#", "url(#" + prefix);
    drop_empty_groups(text);
    return text;
}

std::vector<Figure> figures(const DeviceReport& device) {
    const std::vector<std::string> svgs = draw({pareto_of_roots(device), histograms(device), heat_of_t(device),
                                                heat_of_decisions(device), pareto_of_pictures(device)});
    return {
        {"pareto", "Time against error, formula by formula",
         "Left and low is better. The dashed steps join the Pareto front, whose points are filled; the default has a "
         "ring around it. The error is the largest of the sample, a lower bound; wrong decisions are in the tables.",
         svgs[0]},
        {"histogram", "How often t is how far off",
         "The share of rays whose error of t lies between half of the value on the axis and the value; at the left "
         "end everything up to half an ulp, at the right everything larger.",
         svgs[1]},
        {"heat_t", "The error of t over distance and impact",
         "The largest error of a cell's rays; grey ground means that no ray hit and was found to. The impact is the "
         "distance of the centre from the ray's line, 1 at the limb.",
         svgs[2]},
        {"heat_decisions", "Wrong decisions over distance and impact",
         "The share of a cell's rays that hit and were found not to, or the other way round. White: none.", svgs[3]},
        {"pareto_pictures", "Time against error, picture by picture",
         "A whole picture's time and the largest error of its radiance over the brightest, on sampled pixels.",
         svgs[4]}};
}

}  // namespace gnomon::report
