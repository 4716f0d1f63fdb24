/// Links between nodes of the hierarchy: who sends how much of its light to whom.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "methods/antiradiance/bins.h"
#include "methods/antiradiance/large_array.h"

namespace gibench::antiradiance {

/// The sending node of a link, and the sides that light leaves and arrives on.
struct Sender {
  static constexpr std::uint32_t back_sends = 0x80000000U, back_receives = 0x40000000U;
  std::uint32_t bits = 0;
  std::uint32_t node() const { return bits & ~(back_sends | back_receives); }
  bool from_back() const { return (bits & back_sends) != 0; }
  bool to_back() const { return (bits & back_receives) != 0; }
};

/// The bins that a link's light is taken from and put into.
struct LinkMask {
  std::uint16_t quad = 0;  ///< of DirectionBins
  DirectionMask send, receive;
};

/// Rows by receiving node. 8 bytes per link (sender and factor), 10 more with masks.
struct LinkTable {
  std::vector<std::uint32_t> row_begin;  ///< of every node, and the end
  LargeArray<Sender> senders;
  LargeArray<float> factors;   ///< F from the receiver to the sender: irradiance over π · radiance
  LargeArray<LinkMask> masks;  ///< empty without bins

  std::size_t size() const { return senders.size(); }
  std::size_t bytes() const {
    return row_begin.capacity() * sizeof(std::uint32_t) + senders.capacity() * sizeof(Sender) +
           factors.capacity() * sizeof(float) + masks.capacity() * sizeof(LinkMask);
  }
};

}  // namespace gibench::antiradiance
