// SPDX-License-Identifier: GPL-3.0-or-later
// fails with: static_cast|convert
// A traits class of charts whose number type does not convert to double.
#include <CGAL/Reeb_quadrangulation/Reeb_chart_traits.h>

namespace RQ = CGAL::Reeb_quadrangulation;

struct Traits {
  struct FT {
#ifndef REEBQUAD_LEAVE_OUT
    explicit operator double() const {
      return 1;
    }
#endif
  };
  struct Edge_weight {
    FT operator()(const RQ::Triangle_surface&, int) const { return {}; }
  };
  Edge_weight edge_weight_object(const RQ::Chart&) const {
    return {};
  }
};

RQ::Result<RQ::Chart_parameterization> prepared(const RQ::Chart& chart) {
  return RQ::prepare_chart(chart, Traits());
}
