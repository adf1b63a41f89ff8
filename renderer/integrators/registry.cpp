#include "renderer/error.h"
#include "renderer/integrators/bidirectional/bidirectional.h"
#include "renderer/integrators/integrator.h"
#include "renderer/integrators/metropolis/mlt.h"
#include "renderer/integrators/metropolis/pssmlt.h"
#include "renderer/integrators/path_tracer.h"
#include "renderer/integrators/photon_mapping/mps.h"
#include "renderer/integrators/photon_mapping/photon_mapping.h"
#include "renderer/integrators/progressive_photons/progressive_photons.h"

namespace guidelight {

const std::vector<IntegratorInfo>& integrators() {
  static const std::vector<IntegratorInfo> list = [] {
    std::vector<IntegratorInfo> all = {path_tracer_info()};
    for (IntegratorInfo& info : bidirectional_infos()) all.push_back(std::move(info));
    all.push_back(photon_mapping_info());
    for (IntegratorInfo& info : progressive_photon_infos()) all.push_back(std::move(info));
    all.push_back(mlt_info());
    all.push_back(pssmlt_info());
    all.push_back(mps_info());
    return all;
  }();
  return list;
}

const IntegratorInfo& find_integrator(const std::string& name) {
  std::string known;
  for (const IntegratorInfo& info : integrators()) {
    if (info.name == name) return info;
    known += (known.empty() ? "" : ", ") + info.name;
  }
  throw Error("there is no integrator '{}': choose one of {}", name, known);
}

}  // namespace guidelight
