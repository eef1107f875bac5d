// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pomdp_crowd_nav/pomdp/step_constants.h"

// Robots in a step of the model, and what the map says where they are; a Value is one float or
// sixteen.
namespace pomdp_crowd_nav {

struct Offset {
  float x, y;  // [m]
};

template <class Value>
struct RobotLanes {
  Value x, y, direction_x, direction_y, speed;  // [m], unit vector, [m/s]
};

// What the field says at the robots' places.
template <class Value>
struct FieldLanes {
  Value direction_x, direction_y, clearance;
};

// Where a step takes the robots, people left aside.
template <class Value, int kVias = kHalfWay>
struct MoveLanes {
  using Mask = typename MaskOf<Value>::Type;
  RobotLanes<Value> end;
  Value via_x[kVias], via_y[kVias];  // where it is tested on the way
  FieldLanes<Value> field;           // at the end
  Mask ends_outside;
  Mask hits_obstacle;
};

PCN_INLINE FieldLanes<float> lookUp(const NavigationField& field, float x, float y) {
  const NavigationCell cell = field.at(x, y);
  return {cell.direction_x, cell.direction_y, cell.clearance};
}

template <class Value>
PCN_INLINE typename MaskOf<Value>::Type cellsOf(const NavigationField& field, const Value& x,
                                                const Value& y) {
  using Mask = typename MaskOf<Value>::Type;
  const CellRaster& raster = field.raster();
  const Value zero = spread<Value>(raster.zero);
  const Value from_left = (x - raster.min_x) * raster.cells_per_meter;
  const Value from_bottom = (y - raster.min_y) * raster.cells_per_meter;
  const Value column = smaller(larger(from_left, zero), spread<Value>(raster.last_column));
  const Value row = smaller(larger(from_bottom, zero), spread<Value>(raster.last_row));
  return __builtin_convertvector(row, Mask) * raster.columns +
         __builtin_convertvector(column, Mask);
}

template <class Value>
PCN_INLINE FieldLanes<Value> lookUp(const NavigationField& field, const Value& x, const Value& y) {
  using Mask = typename MaskOf<Value>::Type;
  const Mask cells = cellsOf<Value>(field, x, y);
  const Mask packed = gather(field.directions(), cells);
  FieldLanes<Value> lanes;
  lanes.direction_x = __builtin_convertvector((packed << 16) >> 16, Value) * kPackedUnit;
  lanes.direction_y = __builtin_convertvector(packed >> 16, Value) * kPackedUnit;
  lanes.clearance =
      field.hasObstacles() ? gather<Value>(field.clearances(), cells) : spread<Value>(1e6F);
  return lanes;
}

PCN_INLINE float clearanceAt(const NavigationField& field, float x, float y) {
  return field.clearances()[field.cellOf(x, y)];
}
template <class Value>
PCN_INLINE Value clearanceAt(const NavigationField& field, const Value& x, const Value& y) {
  return gather<Value>(field.clearances(), cellsOf<Value>(field, x, y));
}

}  // namespace pomdp_crowd_nav
