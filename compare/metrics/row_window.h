// A picture file of which only some rows are in memory.
#pragma once

#include <algorithm>

#include "compare/metrics/values.h"
#include "tracer/image/picture_rows.h"

namespace verisim::compare {

class RowWindow {
 public:
  explicit RowWindow(const std::filesystem::path& path) : rows_(image::open_rows(path)) {
    shape_.width = rows_->width, shape_.height = rows_->height, shape_.channels = rows_->channels,
    shape_.bits = rows_->bits, shape_.is_float = rows_->is_float;
    window_ = shape_;
  }
  const Picture& shape() const { return shape_; }  // without samples
  const Picture* whole() const { return rows_->whole(); }

  // The rows from first to last, until the next call. Neither may become smaller from call to call. Throws
  // std::runtime_error when the file is damaged.
  Values show(int first, int last) {
    const std::size_t row = static_cast<std::size_t>(shape_.width) * static_cast<std::size_t>(shape_.channels);
    for (; end_ < first; ++end_)
      window_.samples.resize(row), rows_->next(window_.samples.data()), window_.samples.clear();  // passed over
    const int kept_from = std::max(first, begin_), dropped = std::min(kept_from, end_) - begin_;
    if (dropped > 0 && !window_.samples.empty())
      window_.samples.erase(window_.samples.begin(),
                            window_.samples.begin() + static_cast<std::ptrdiff_t>(row) * dropped);
    begin_ = first;
    window_.samples.resize(row * static_cast<std::size_t>(last - first));
    for (; end_ < last; ++end_) rows_->next(window_.samples.data() + row * static_cast<std::size_t>(end_ - first));
    window_.height = last - first;
    return Values(window_, first, shape_.height);
  }

 private:
  std::unique_ptr<image::PictureRows> rows_;
  Picture shape_, window_;
  int begin_ = 0, end_ = 0;  // rows in window_
};

}  // namespace verisim::compare
