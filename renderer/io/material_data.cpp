#include "renderer/io/material_data.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace guidelight {
namespace {

struct NamedIor {
  std::string_view name;
  float ior;
};

/// At the sodium D line, 589.3 nm, room temperature and normal pressure (textbook values; the list
/// of names is that of Mitsuba's documentation).
constexpr std::array kIors = {
    NamedIor{"vacuum", 1.0f},
    NamedIor{"helium", 1.000036f},
    NamedIor{"hydrogen", 1.000132f},
    NamedIor{"air", 1.000277f},
    NamedIor{"carbon dioxide", 1.00045f},
    NamedIor{"water ice", 1.31f},
    NamedIor{"water", 1.3330f},
    NamedIor{"acetone", 1.36f},
    NamedIor{"ethanol", 1.361f},
    NamedIor{"fused quartz", 1.458f},
    NamedIor{"carbon tetrachloride", 1.461f},
    NamedIor{"pyrex", 1.470f},
    NamedIor{"glycerol", 1.4729f},
    NamedIor{"acrylic glass", 1.49f},
    NamedIor{"polypropylene", 1.49f},
    NamedIor{"benzene", 1.501f},
    NamedIor{"bk7", 1.5046f},
    NamedIor{"silicone oil", 1.52045f},
    NamedIor{"sodium chloride", 1.544f},
    NamedIor{"amber", 1.55f},
    NamedIor{"pet", 1.5750f},
    NamedIor{"bromine", 1.661f},
    NamedIor{"diamond", 2.419f},
};

struct NamedConductor {
  std::string_view name;
  ConductorData data;
};

/// Measured complex indices (Palik's Handbook of Optical Constants of Solids and the SOPRA tables,
/// under the names that Mitsuba gives them), integrated with the CIE 1931 functions to linear sRGB.
constexpr std::array kConductors = {
    NamedConductor{"none", {Color(0.0f), Color(1.0f)}},
    NamedConductor{"a-C", {{2.94410f, 2.22715f, 1.96817f}, {0.887433f, 0.799322f, 0.815286f}}},
    NamedConductor{"Ag", {{0.155265f, 0.116723f, 0.138381f}, {4.82834f, 3.12225f, 2.14705f}}},
    NamedConductor{"Al", {{1.65746f, 0.880369f, 0.521229f}, {9.22387f, 6.26952f, 4.83700f}}},
    NamedConductor{"Au", {{0.143119f, 0.374957f, 1.44248f}, {3.98316f, 2.38572f, 1.60322f}}},
    NamedConductor{"Be", {{4.18506f, 3.18506f, 2.78409f}, {3.83544f, 3.01013f, 2.86901f}}},
    NamedConductor{"Cr", {{4.36968f, 2.91670f, 1.65470f}, {5.20643f, 4.23136f, 3.75495f}}},
    NamedConductor{"CsI", {{2.14490f, 1.70232f, 1.66242f}, Color(0.0f)}},
    NamedConductor{"Cu", {{0.200438f, 0.924033f, 1.10221f}, {3.91295f, 2.45285f, 2.14219f}}},
    NamedConductor{"Cu2O", {{3.54928f, 2.95206f, 2.73692f}, {0.113218f, 0.194666f, 0.600168f}}},
    NamedConductor{"CuO", {{3.24538f, 2.44963f, 2.19741f}, {0.520274f, 0.570737f, 0.717225f}}},
    NamedConductor{"d-C", {{2.71125f, 2.31858f, 2.22886f}, Color(0.0f)}},
    NamedConductor{"Hg", {{2.39893f, 1.44003f, 0.909551f}, {6.32763f, 4.37194f, 3.42179f}}},
    NamedConductor{"HgTe", {{4.77953f, 3.23100f, 2.66003f}, {1.63198f, 1.58082f, 1.72958f}}},
    NamedConductor{"Ir", {{3.08641f, 2.08219f, 1.61789f}, {5.59215f, 4.06718f, 3.26726f}}},
    NamedConductor{"K", {{0.0640493f, 0.0464101f, 0.0381842f}, {2.10422f, 1.34894f, 0.913211f}}},
    NamedConductor{"Li", {{0.265787f, 0.195610f, 0.220920f}, {3.54017f, 2.31113f, 1.66859f}}},
    NamedConductor{"MgO", {{2.08959f, 1.65072f, 1.59488f}, Color(0.0f)}},
    NamedConductor{"Mo", {{4.48370f, 3.52546f, 2.77608f}, {4.11113f, 3.42087f, 3.15060f}}},
    NamedConductor{"Na", {{0.0602665f, 0.0561412f, 0.0619909f}, {3.17929f, 2.11248f, 1.57909f}}},
    NamedConductor{"Nb", {{3.42014f, 2.79019f, 2.39559f}, {3.44138f, 2.73764f, 2.57991f}}},
    NamedConductor{"Ni", {{2.36728f, 1.66336f, 1.46706f}, {4.49883f, 3.05016f, 2.34543f}}},
    NamedConductor{"Rh", {{2.58580f, 1.86019f, 1.55443f}, {6.78229f, 4.70295f, 3.97609f}}},
    NamedConductor{"Ta", {{2.06258f, 2.39309f, 2.62807f}, {2.40805f, 1.74137f, 1.94704f}}},
    NamedConductor{"TiC", {{3.70047f, 2.83744f, 2.58230f}, {3.26569f, 2.35156f, 2.17279f}}},
    NamedConductor{"TiN", {{1.64847f, 1.15045f, 1.37978f}, {3.36846f, 1.94349f, 1.10201f}}},
    NamedConductor{"V", {{4.27751f, 3.51315f, 2.76113f}, {3.49118f, 2.88936f, 3.11170f}}},
    NamedConductor{"VC", {{3.65757f, 2.75273f, 2.53268f}, {3.06835f, 2.19867f, 1.96318f}}},
    NamedConductor{"VN", {{2.86560f, 2.11918f, 1.94008f}, {3.03233f, 2.05611f, 1.61629f}}},
    NamedConductor{"W", {{4.37070f, 3.30030f, 2.99827f}, {3.50068f, 2.60487f, 2.27319f}}},
};

bool same_ignoring_case(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](unsigned char x, unsigned char y) {
    return std::tolower(x) == std::tolower(y);
  });
}

}  // namespace

std::optional<float> named_ior(std::string_view name) {
  for (const NamedIor& entry : kIors) {
    if (same_ignoring_case(entry.name, name)) return entry.ior;
  }
  return std::nullopt;
}

std::optional<ConductorData> named_conductor(std::string_view name) {
  // Measurements of the same metal by other groups carry a suffix ("Cu_palik").
  const std::string_view base = name.substr(0, name.find('_'));
  for (const NamedConductor& entry : kConductors) {
    if (entry.name == name || entry.name == base || same_ignoring_case(entry.name, name)) {
      return entry.data;
    }
  }
  return std::nullopt;
}

}  // namespace guidelight
