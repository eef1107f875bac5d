// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/rviz_panel/sparkline.h"

#include <QPainter>

namespace pomdp_crowd_nav {

Sparkline::Sparkline(QWidget* parent) : QWidget(parent) {
  setMinimumHeight(48);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setToolTip(
      "time that each of the last decisions took, the newest at the right; late ones in red; "
      "the line is the deadline");
}

void Sparkline::show(const CycleHistory& history, std::optional<double> deadline) {
  if (history.times() == history_.times() && deadline == deadline_) return;
  history_ = history;
  deadline_ = deadline;
  update();
}

void Sparkline::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), Qt::white);
  const CycleBars bars = barsOf(history_, deadline_, width(), height());
  for (const CycleBars::Bar& bar : bars.bars) {
    const QRectF area(bar.left, bar.top, 0.8 * bars.width, height() - bar.top);
    painter.fillRect(area, QColor(bar.is_late ? kLate : kInTime));
  }
  if (!bars.deadline_top) return;
  painter.setPen(QPen(QColor(kDeadline), 1.5, Qt::DashLine));
  painter.drawLine(QPointF(0.0, *bars.deadline_top), QPointF(width(), *bars.deadline_top));
  painter.setPen(Qt::black);
  painter.drawText(QPointF(3.0, *bars.deadline_top + painter.fontMetrics().ascent() + 1.0),
                   QString::asprintf("%.2f s", *deadline_));
}

}  // namespace pomdp_crowd_nav
