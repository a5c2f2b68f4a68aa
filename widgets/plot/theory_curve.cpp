#include "widgets/plot/theory_curve.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <limits>
#include <qwt_clipper.h>
#include <qwt_scale_map.h>

namespace carom {
namespace {

constexpr double kSteep = 2.0;       // px: intervals between neighbours further apart are refined
constexpr int kHalvings = 6;         // of a pixel: below visibility
constexpr int kPoleHalvings = 40;    // enough to tell a jump, which keeps its height, from a pole
constexpr int kMostValues = 40'000;  // a picture: some 10 ms; a line full of jumps stays coarse beyond

// Builds one line, from left to right.
template <class Value>
class Tracer {
 public:
  Tracer(const Value& value, const QwtScaleMap& x, const QwtScaleMap& y) : value_(value), x_(x), y_(y) {}

  void go_to(double pixel) {
    const QPointF next = at(pixel);
    if (!started_ || std::isnan(next.y()) || std::isnan(last_.y())) {
      if (started_) edge(last_, next);
      if (!std::isnan(next.y())) put(next);
    } else {
      join(last_, next, kHalvings);
    }
    started_ = true;
    last_ = next;
  }
  std::vector<QPolygonF> take() {
    end_piece();
    return std::move(pieces_);
  }

 private:
  [[nodiscard]] QPointF at(double pixel) {
    ++asked_;
    const double y = value_(x_.invTransform(pixel));
    return {pixel, std::isfinite(y) ? y_.transform(y) : std::numeric_limits<double>::quiet_NaN()};
  }
  void put(const QPointF& point) { piece_.append(point); }
  void end_piece() {
    if (!piece_.isEmpty()) pieces_.push_back(std::exchange(piece_, {}));
  }

  // Extends the line from a, which is on it already, to b.
  void join(const QPointF& a, const QPointF& b, int halvings) {
    if (std::abs(b.y() - a.y()) > kSteep && asked_ < kMostValues) {
      if (halvings > 0) {
        const QPointF middle = at(0.5 * (a.x() + b.x()));
        if (!std::isnan(middle.y())) {
          join(a, middle, halvings - 1);
          join(middle, b, halvings - 1);
          return;
        }
      }
      if (is_pole(a, b)) end_piece();
    }
    put(b);
  }
  // Under refinement a jump keeps its height and a pole grows.
  [[nodiscard]] bool is_pole(QPointF a, QPointF b) {
    const double height = std::abs(b.y() - a.y());
    for (int i = 0; i < kPoleHalvings; ++i) {
      const QPointF middle = at(0.5 * (a.x() + b.x()));
      if (std::isnan(middle.y())) return true;
      (std::abs(middle.y() - a.y()) > std::abs(b.y() - middle.y()) ? b : a) = middle;
    }
    return std::abs(b.y() - a.y()) > 1.5 * height;
  }
  // The line begins or ends between a and b.
  void edge(QPointF a, QPointF b) {
    const bool ends = !std::isnan(a.y());
    if (ends == !std::isnan(b.y())) return;
    for (int i = 0; i < kHalvings; ++i) {
      const QPointF middle = at(0.5 * (a.x() + b.x()));
      (std::isnan(middle.y()) == ends ? b : a) = middle;
    }
    if (ends) {
      put(a);
      end_piece();
    } else {
      put(b);
    }
  }

  const Value& value_;
  const QwtScaleMap& x_;
  const QwtScaleMap& y_;
  bool started_ = false;
  int asked_ = 0;
  QPointF last_;
  QPolygonF piece_;
  std::vector<QPolygonF> pieces_;
};

}  // namespace

TheoryCurve::TheoryCurve(const Expression& formula, bool over_x, bool magnitudes)
    : formula_(formula), over_x_(over_x), magnitudes_(magnitudes) {
  setRenderHint(RenderAntialiased);
}

void TheoryCurve::set_pen(const QPen& pen) {
  pen_ = pen;
  pen_.setCapStyle(Qt::FlatCap);
}

double TheoryCurve::shown(double value) const {
  if (!magnitudes_) return value;
  return value == 0.0 ? std::numeric_limits<double>::quiet_NaN() : std::abs(value);
}

double TheoryCurve::value(double at) const { return shown(over_x_ ? formula_(0.0, at) : formula_(at)); }

void TheoryCurve::take(const Series<2>& path, const QwtInterval& time) {
  std::vector<SeriesPoint<2>> read;
  path.read(time.minValue(), time.maxValue(), read);
  points_.clear();
  for (const SeriesPoint<2>& p : read) points_.emplace_back(p.value[1], shown(formula_(p.at, p.value[1])));
}

std::vector<double> TheoryCurve::values(const QwtInterval& x) const {
  constexpr int kParts = 200;
  std::vector<double> all;
  const auto take = [&all](double y) {
    if (std::isfinite(y)) all.push_back(y);
  };
  if (needs_path()) {
    for (const QPointF& p : points_) take(p.y());
  } else {
    for (int i = 0; i <= kParts; ++i) take(value(x.minValue() + x.width() * i / kParts));
  }
  std::sort(all.begin(), all.end());
  return all;
}

QwtInterval TheoryCurve::spread(const QwtInterval& x) const {
  const std::vector<double> all = values(x);
  return all.empty() ? QwtInterval() : QwtInterval(all.front(), all.back());
}

QwtInterval TheoryCurve::usual_spread(const QwtInterval& x) const {
  constexpr std::size_t kShare = 20;  // one in so many values is left out at either end
  const std::vector<double> all = values(x);
  if (all.empty()) return {};
  const double low = all[all.size() / kShare];
  const double high = all[all.size() - 1 - all.size() / kShare];
  return {std::max(all.front(), low - (high - low)), std::min(all.back(), high + (high - low))};
}

std::vector<QPolygonF> TheoryCurve::pieces(const QwtScaleMap& x, const QwtScaleMap& y,
                                           const QRectF& canvas) const {
  if (needs_path()) {
    std::vector<QPolygonF> all(1);
    for (const QPointF& p : points_) {
      if (std::isfinite(p.y())) {
        all.back().append(QwtScaleMap::transform(x, y, p));
      } else if (!all.back().isEmpty()) {
        all.emplace_back();
      }
    }
    return all;
  }
  const auto ask = [this](double at) { return value(at); };
  Tracer tracer(ask, x, y);
  for (double pixel = canvas.left(); pixel < canvas.right(); pixel += 1.0) tracer.go_to(pixel);
  tracer.go_to(canvas.right());
  return tracer.take();
}

void TheoryCurve::draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y,
                       const QRectF& canvas) const {
  painter->setPen(pen_);
  constexpr double kMargin = 10.0;  // px, more than the pen's width
  for (QPolygonF& piece : pieces(x, y, canvas)) {
    QwtClipper::clipPolygonF(canvas.adjusted(-kMargin, -kMargin, kMargin, kMargin), piece, false);
    painter->drawPolyline(piece);
  }
}

}  // namespace carom
