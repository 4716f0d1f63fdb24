#include "methods/wavelet/transport_operator.h"

#include <algorithm>
#include <cmath>

namespace gibench::wavelet {

namespace {

constexpr std::size_t row_chunk = 32;
constexpr float most_packed = 32767.0F;

}  // namespace

TransportOperator::TransportOperator(const Elements& elements, std::vector<LinkRows>&& parts, Precision precision) {
  std::size_t links = 0, numbers = 0;
  for (const LinkRows& part : parts) links += part.senders.size(), numbers += part.coefficients.size();
  senders_.reserve(links);
  coefficients_.reserve(numbers);
  row_begin_.assign(1, 0);
  for (LinkRows& part : parts) {
    for (const std::uint32_t count : part.counts) row_begin_.push_back(row_begin_.back() + count);
    senders_.insert(senders_.end(), part.senders.begin(), part.senders.end());
    coefficients_.insert(coefficients_.end(), part.coefficients.begin(), part.coefficients.end());
    part = {};
  }
  std::size_t at = 0;
  for (std::uint32_t receiver = 0; receiver + 1 < row_begin_.size(); ++receiver) {
    coefficient_begin_.push_back(at);
    for (std::uint32_t link = row_begin_[receiver]; link < row_begin_[receiver + 1]; ++link)
      at += elements.groups()[receiver].functions() * elements.groups()[senders_[link]].functions();
  }
  if (precision == Precision::bits16) pack();
}

void TransportOperator::pack() {
  packed_.reserve(coefficients_.size());
  for (std::size_t row = 0; row < coefficient_begin_.size(); ++row) {
    const std::size_t begin = coefficient_begin_[row],
                      end = row + 1 < coefficient_begin_.size() ? coefficient_begin_[row + 1] : coefficients_.size();
    float largest = 0.0F;
    for (std::size_t i = begin; i < end; ++i) largest = std::max(largest, std::fabs(coefficients_[i]));
    step_of_row_.push_back(largest / most_packed);
    const float to_steps = largest > 0.0F ? most_packed / largest : 0.0F;
    for (std::size_t i = begin; i < end; ++i)
      packed_.push_back(static_cast<std::int16_t>(std::lround(coefficients_[i] * to_steps)));
  }
  std::vector<float>().swap(coefficients_);
}

std::size_t TransportOperator::bytes() const {
  return (row_begin_.capacity() + senders_.capacity()) * sizeof(std::uint32_t) +
         coefficient_begin_.capacity() * sizeof(std::size_t) +
         (coefficients_.capacity() + step_of_row_.capacity()) * sizeof(float) + packed_.capacity() * sizeof(std::int16_t);
}

void TransportOperator::apply(const Elements& elements, std::span<const Rgb> in, std::span<Rgb> out, Task& task) const {
  const std::span groups = elements.groups();
  task.parallel_chunks(groups.size(), row_chunk, [&](const ChunkRange& range) {
    for (auto receiver = static_cast<std::uint32_t>(range.begin); receiver < range.end; ++receiver) {
      const Group& to = groups[receiver];
      std::array<Rgb, child_count> sum{};
      each_link(elements, receiver, [&](std::uint32_t sender, std::span<const float> coefficients) {
        const Group& from = groups[sender];
        const Rgb* light = &in[sender * child_count];
        const float* next = coefficients.data();
        for (std::size_t k = to.first; k < to.end; ++k)
          for (std::size_t j = from.first; j < from.end; ++j) sum[k] += light[j] * *next++;
      });
      for (std::size_t k = 0; k < child_count; ++k) out[receiver * child_count + k] = sum[k];
    }
  });
}

}  // namespace gibench::wavelet
