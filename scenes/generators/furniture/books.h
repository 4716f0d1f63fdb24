/// Books: single volumes and rows of them.
#pragma once

#include <array>

#include "scenes/generators/shapes.h"

namespace gibench::generators {

/// What a book is made of; two closed parts that do not touch.
struct Book {
  Mesh cover, pages;
};

/// A closed book standing on y = 0 with its spine towards +z: `thickness` along x from 0, `height` along y, `depth` back
/// to z = -depth. The pages lie a millimetre inside their cover.
Book book(double thickness, double height, double depth);

inline constexpr std::size_t cover_colours = 5;

/// Books side by side, by the colour of their covers; the colours have an order, not a meaning.
struct BookRow {
  std::array<Mesh, cover_colours> covers;
  Mesh pages;
};

/// Books along x from 0 to at most `length`, none taller than `room` (metres), spines near z = 0; some lean, some lie on
/// one another, and there are gaps. `thickness` is the mean one, metres.
BookRow book_row(double length, double room, double thickness, RandomStream& random);

/// An open book lying about the origin, its head towards -z: two arched halves of pages and the cover under them.
Book open_book(double width, double height);

}  // namespace gibench::generators
