#include "elements.h"

#include <cstdint>
#include <string>
#include <unordered_map>

#include "srgb.h"
#include "text_lines.h"

namespace gnomon {

namespace {

struct ElementRow {
    const char* symbol;
    double radius;   ///< angstrom
    uint32_t color;  ///< sRGB, 8 bits each: 0xRRGGBB
};

// Van der Waals radii. The main groups: Mantina, Chamberlin, Valero, Cramer and Truhlar, J. Phys. Chem. A 2009, 113,
// 5806, table 12, which has Bondi's (J. Phys. Chem. 1964, 68, 441) and, by his method, those he lacks. The other
// groups: Alvarez, Dalton Trans. 2013, 42, 8617. Colours: Jmol's, https://jmol.sourceforge.net/jscolors/, which go back
// to the models of Corey, Pauling and Koltun. In the order of atomic numbers, from 1.
constexpr ElementRow rows[] = {
    {"H", 1.10, 0xFFFFFF},  {"He", 1.40, 0xD9FFFF}, {"Li", 1.81, 0xCC80FF}, {"Be", 1.53, 0xC2FF00},
    {"B", 1.92, 0xFFB5B5},  {"C", 1.70, 0x909090},  {"N", 1.55, 0x3050F8},  {"O", 1.52, 0xFF0D0D},
    {"F", 1.47, 0x90E050},  {"Ne", 1.54, 0xB3E3F5}, {"Na", 2.27, 0xAB5CF2}, {"Mg", 1.73, 0x8AFF00},
    {"Al", 1.84, 0xBFA6A6}, {"Si", 2.10, 0xF0C8A0}, {"P", 1.80, 0xFF8000},  {"S", 1.80, 0xFFFF30},
    {"Cl", 1.75, 0x1FF01F}, {"Ar", 1.88, 0x80D1E3}, {"K", 2.75, 0x8F40D4},  {"Ca", 2.31, 0x3DFF00},
    {"Sc", 2.58, 0xE6E6E6}, {"Ti", 2.46, 0xBFC2C7}, {"V", 2.42, 0xA6A6AB},  {"Cr", 2.45, 0x8A99C7},
    {"Mn", 2.45, 0x9C7AC7}, {"Fe", 2.44, 0xE06633}, {"Co", 2.40, 0xF090A0}, {"Ni", 2.40, 0x50D050},
    {"Cu", 2.38, 0xC88033}, {"Zn", 2.39, 0x7D80B0}, {"Ga", 1.87, 0xC28F8F}, {"Ge", 2.11, 0x668F8F},
    {"As", 1.85, 0xBD80E3}, {"Se", 1.90, 0xFFA100}, {"Br", 1.83, 0xA62929}, {"Kr", 2.02, 0x5CB8D1},
    {"Rb", 3.03, 0x702EB0}, {"Sr", 2.49, 0x00FF00}, {"Y", 2.75, 0x94FFFF},  {"Zr", 2.52, 0x94E0E0},
    {"Nb", 2.56, 0x73C2C9}, {"Mo", 2.45, 0x54B5B5}, {"Tc", 2.44, 0x3B9E9E}, {"Ru", 2.46, 0x248F8F},
    {"Rh", 2.44, 0x0A7D8C}, {"Pd", 2.15, 0x006985}, {"Ag", 2.53, 0xC0C0C0}, {"Cd", 2.49, 0xFFD98F},
    {"In", 1.93, 0xA67573}, {"Sn", 2.17, 0x668080}, {"Sb", 2.06, 0x9E63B5}, {"Te", 2.06, 0xD47A00},
    {"I", 1.98, 0x940094},  {"Xe", 2.16, 0x429EB0}, {"Cs", 3.43, 0x57178F}, {"Ba", 2.68, 0x00C900},
    {"La", 2.98, 0x70D4FF}, {"Ce", 2.88, 0xFFFFC7}, {"Pr", 2.92, 0xD9FFC7}, {"Nd", 2.95, 0xC7FFC7},
    {"Pm", 0, 0xA3FFC7},    {"Sm", 2.90, 0x8FFFC7}, {"Eu", 2.87, 0x61FFC7}, {"Gd", 2.83, 0x45FFC7},
    {"Tb", 2.79, 0x30FFC7}, {"Dy", 2.87, 0x1FFFC7}, {"Ho", 2.81, 0x00FF9C}, {"Er", 2.83, 0x00E675},
    {"Tm", 2.79, 0x00D452}, {"Yb", 2.80, 0x00BF38}, {"Lu", 2.74, 0x00AB24}, {"Hf", 2.63, 0x4DC2FF},
    {"Ta", 2.53, 0x4DA6FF}, {"W", 2.57, 0x2194D6},  {"Re", 2.49, 0x267DAB}, {"Os", 2.48, 0x266696},
    {"Ir", 2.41, 0x175487}, {"Pt", 2.29, 0xD0D0E0}, {"Au", 2.32, 0xFFD123}, {"Hg", 2.45, 0xB8B8D0},
    {"Tl", 1.96, 0xA6544D}, {"Pb", 2.02, 0x575961}, {"Bi", 2.07, 0x9E4FB5}, {"Po", 1.97, 0xAB5C00},
    {"At", 2.02, 0x754F45}, {"Rn", 2.20, 0x428296}, {"Fr", 3.48, 0x420066}, {"Ra", 2.83, 0x007D00},
    {"Ac", 2.80, 0x70ABFA}, {"Th", 2.93, 0x00BAFF}, {"Pa", 2.88, 0x00A1FF}, {"U", 2.71, 0x008FFF},
    {"Np", 2.82, 0x0080FF}, {"Pu", 2.81, 0x006BFF}, {"Am", 2.83, 0x545CF2}, {"Cm", 3.05, 0x785CE3},
    {"Bk", 3.40, 0x8A4FE3}, {"Cf", 3.05, 0xA136D4}, {"Es", 2.70, 0xB31FD4}, {"Fm", 0, 0xB31FBA},
    {"Md", 0, 0xB30DA6},    {"No", 0, 0xBD0D87},    {"Lr", 0, 0xC70066},    {"Rf", 0, 0xCC0059},
    {"Db", 0, 0xD1004F},    {"Sg", 0, 0xD90045},    {"Bh", 0, 0xE00038},    {"Hs", 0, 0xE6002E},
    {"Mt", 0, 0xEB0026}};

Rgb albedo_of(uint32_t color) {
    const auto channel = [&](int shift) { return srgb_decode(((color >> shift) & 0xFF) / 255.0); };
    return {channel(16), channel(8), channel(0)};
}

/// By symbol in small letters, and by atomic number.
std::unordered_map<std::string, Element> make_elements() {
    std::unordered_map<std::string, Element> elements;
    int number = 0;
    for (const ElementRow& row : rows) {
        const Element element{row.radius, albedo_of(row.color)};
        elements[lower_case(row.symbol)] = elements[std::to_string(++number)] = element;
    }
    return elements;
}

}  // namespace

const Element* find_element(std::string_view name) {
    static const std::unordered_map<std::string, Element> elements = make_elements();
    const auto found = elements.find(lower_case(name));
    return found == elements.end() ? nullptr : &found->second;
}

}  // namespace gnomon
