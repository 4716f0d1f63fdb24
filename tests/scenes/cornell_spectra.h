/// The Cornell box's published spectra and what turns a spectrum into linear Rec. 709.
#pragma once

#include <array>
#include <cstddef>

namespace gibench::cornell {

/// Reflectances in thousandths at 400, 404, …, 700 nm (Cornell Box Data, Program of Computer Graphics).
inline constexpr std::array<int, 76> white{343, 445, 551, 624, 665, 687, 708, 723, 715, 710, 745, 758, 739, 767, 777, 765,
                                           751, 745, 748, 729, 745, 757, 753, 750, 746, 747, 735, 732, 739, 734, 725, 721,
                                           733, 725, 732, 743, 744, 748, 728, 716, 733, 726, 713, 740, 754, 764, 752, 736,
                                           734, 741, 740, 732, 745, 755, 751, 744, 731, 733, 744, 731, 712, 708, 729, 730,
                                           727, 707, 703, 729, 750, 760, 751, 739, 724, 730, 740, 737};
inline constexpr std::array<int, 76> green{92,  96,  98,  97,  98,  95,  95,  97,  95,  94,  97,  98,  96,  101, 103, 104,
                                           107, 109, 112, 115, 125, 140, 160, 187, 229, 285, 343, 390, 435, 464, 472, 476,
                                           481, 462, 447, 441, 426, 406, 373, 347, 337, 314, 285, 277, 266, 250, 230, 207,
                                           186, 171, 160, 148, 141, 136, 130, 126, 123, 121, 122, 119, 114, 115, 117, 117,
                                           118, 120, 122, 128, 132, 139, 144, 146, 150, 152, 157, 159};
inline constexpr std::array<int, 76> red{40,  46,  48,  53,  49,  50,  53,  55,  57,  56,  59,  57,  61,  61,  60,  62,
                                         62,  62,  61,  62,  60,  59,  57,  58,  58,  58,  56,  55,  56,  59,  57,  55,
                                         59,  59,  58,  59,  61,  61,  63,  63,  67,  68,  72,  80,  90,  99,  124, 154,
                                         192, 255, 287, 349, 402, 443, 487, 513, 558, 584, 620, 606, 609, 651, 612, 610,
                                         650, 638, 627, 620, 630, 628, 642, 639, 657, 639, 635, 642};
/// The light's spectrum at 400, 500, 600, 700 nm, linear in between.
inline constexpr std::array<double, 4> light{0.0, 8.0, 15.6, 18.4};

/// CIE 1931 two-degree colour-matching functions and illuminant D65 at 400, 410, …, 700 nm.
inline constexpr std::array<double, 31> x_bar{
    .01431, .04351, .13438, .2839,  .34828, .3362,  .2908,  .19536, .09564, .03201, .0049, .0093, .06327, .1655, .2904,  .43345,
    .5945,  .7621,  .9163,  1.0263, 1.0622, 1.0026, .85445, .6424,  .4479,  .2835,  .1649, .0874, .04677, .0227, .011359};
inline constexpr std::array<double, 31> y_bar{.000396, .00121, .004, .0116, .023, .038, .06,  .09098, .13902, .20802, .323,
                                              .503,    .71,    .862, .954,  .995, .995, .952, .87,    .757,   .631,   .503,
                                              .381,    .265,   .175, .107,  .061, .032, .017, .00821, .004102};
inline constexpr std::array<double, 31> z_bar{
    .06785, .2074, .6456,  1.3856, 1.74706, 1.77211, 1.6692, 1.28764, .81295, .46518, .272, .1582, .07825, .04216, .0203, .00875,
    .0039,  .0021, .00165, .0011,  .0008,   .00034,  .00019, .00005,  .00002, 0.0,    0.0,  0.0,   0.0,    0.0,    0.0};
inline constexpr std::array<double, 31> d65{82.7549, 91.486,  93.4318, 86.6823, 104.865, 117.008, 117.812, 114.861,
                                            115.923, 108.811, 109.354, 107.802, 104.79,  107.689, 104.405, 104.046,
                                            100.0,   96.3342, 95.788,  88.6856, 90.0062, 89.5991, 87.6987, 83.2886,
                                            83.6992, 80.0268, 80.2146, 82.2778, 78.2842, 69.7213, 71.6091};

/// A table of values `step` nm apart from 400 nm, linear in between.
template <class T, std::size_t size>
constexpr double at(const std::array<T, size>& table, double step, double nanometres) {
  const double place = (nanometres - 400.0) / step;
  const auto below = static_cast<std::size_t>(place) < size - 1 ? static_cast<std::size_t>(place) : size - 2;
  const double share = place - static_cast<double>(below);
  return (1.0 - share) * static_cast<double>(table[below]) + share * static_cast<double>(table[below + 1]);
}

}  // namespace gibench::cornell
