#pragma once

namespace guidelight {

/// What a subpath vertex carries of the balance heuristic, so that the weight of a full path costs
/// O(1) wherever the path is closed. Derivation in docs/mis.md; the recurrence is in
/// renderer/transport/mis.h.
///
/// `connection` and `merging` still lack one factor, the density of scattering at this vertex back
/// to the one before, which is known only when the path is closed. Neither contains the number of
/// light paths or the merging radius.
struct MisPartials {
  float inverse_pdf = 0;  // 1/p of this vertex [area]; 0 if the vertex before cannot be connected
  float connection = 0;   // techniques that connect at an earlier edge
  float merging = 0;      // techniques that merge at an earlier vertex
};

}  // namespace guidelight
