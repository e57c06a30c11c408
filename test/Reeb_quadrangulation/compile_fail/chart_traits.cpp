// SPDX-License-Identifier: GPL-3.0-or-later
// fails with: edge_weight_object
// A traits class of charts that cannot make its functor.
#include <CGAL/Reeb_quadrangulation/Reeb_chart_traits.h>

namespace RQ = CGAL::Reeb_quadrangulation;

struct Traits {
  using FT = double;
  struct Edge_weight {
    FT operator()(const RQ::Triangle_surface&, int) const { return 1; }
  };
#ifndef REEBQUAD_LEAVE_OUT
  Edge_weight edge_weight_object(const RQ::Chart&) const {
    return {};
  }
#endif
};

RQ::Result<RQ::Chart_parameterization> prepared(const RQ::Chart& chart) {
  return RQ::prepare_chart(chart, Traits());
}
