/**
 * What holds of each hard case, by its id, in words; the tests hold it to figures. Apart from the cases, so that a page
 * which only shows them does not carry it.
 */
export const hardCaseClaims: Readonly<Record<string, string>> = {
  'stops-on-the-flat':
    'With located stops every method of second order is exact to rounding at any frame rate; naive stops never rest.',
  'stops-uphill':
    'With located stops every method of second order is exact to rounding; clamped ones rest, but up to a frame off.',
  'comes-back':
    'With located stops every method of second order is exact to rounding through the turn.',
  'held-or-sliding': 'Static friction decides at v = 0 and nowhere else.',
  'edge-of-holding':
    'tan α ≤ μs stays to the bit for an hour; tan α above it by 1e-12 slides as it should.',
  'like-glue':
    'With located stops every method of second order is exact to rounding; clamped ones stop within the frame.',
  'vertical-wall': 'It falls like the ball, and the heat is exactly 0.',
  'level-ramp': 'v never changes by a bit.',
  'half-second-hitch': 'Located Verlet ends where it ends at a steady 60 fps, to rounding.',
  'five-fps': 'Located Verlet ends where it ends at a steady 60 fps, to rounding.',
  'wild-jitter': 'Located Verlet ends where it ends at a steady 60 fps, to rounding.',
  'long-clock': 'After ten million frames the clock is off by one rounding at the most.',
  'spiral-of-death':
    'No frame takes more steps than its bound, and all the time that is dropped is reported.',
  'pipe-from-89-degrees':
    'Symplectic methods stay in an energy band for 10 000 s, rk4 only loses, and the two explicit ones of low order are thrown out.',
  'below-verlets-limit': 'Bounded by 1/√(1 − (ωΔt/2)²), ten times the start, for ever.',
  'at-verlets-limit': 'Verlet and semi-implicit Euler grow at most linearly.',
  'beyond-verlets-limit':
    'The growth is the theory’s, and the outcome says that it diverged, and when.',
  'below-rk4s-limit': 'rk4 and implicit midpoint stay bounded, all others diverge.',
  'beyond-rk4s-limit': 'rk4 diverges after as many steps as the theory says.',
  'stiff-as-steel': 'Implicit midpoint keeps the energy to rounding, and solves every step.',
  'many-reversals': 'Every turn is found, and each method is as near as its order says.',
  'many-reversals-in-a-step': 'The run ends, with numbers, after a bounded number of evaluations.',
  'smallest-numbers': 'No result is NaN or infinite, and a tiny swing is a small one made smaller.',
  'largest-numbers':
    'Located methods of second order are off by an ulp of the position a step at the most.',
  'zero-gravity': 'On a straight the speed keeps its bits, and a block at rest stays.',
  'zero-mass': 'It is refused, and the message names the mass and its range.',
  'zero-duration': 'One row, no frame, no step.',
  'joint-and-stop-in-a-step': 'All of them are found inside the one step, and the block rests.',
  'joints-of-no-bend':
    'Located methods of second order are exact to rounding through both joints and the stop.',
  'stop-at-a-frames-end': 'It rests at 1 s after 2.5 m, to rounding.',
  'stop-at-a-joint': 'It rests within a few ulps of the joint, and does not creep.',
  'joint-at-a-frames-end':
    'A block without friction on the level crosses both joints without a trace.',
}
