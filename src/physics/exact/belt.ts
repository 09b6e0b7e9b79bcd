import { ExactSum } from '../exactSum.ts'
import { frictionHolds } from '../holds.ts'
import type { ExactMotion, State } from '../state.ts'
import { cardinal } from '../trigonometry.ts'

/** The belt and the block on it, with forces per mass; friction is μ g [m/s²]. */
interface Belt {
  readonly speed: number
  /** The spring's k/m [1/s²]. */
  readonly stiffness: number
  readonly kinetic: number
  readonly static: number
}

/** A phase with one law: the block rides on the belt, or slides under the spring and constant friction. */
interface Phase extends State {
  readonly rides: boolean
  /** The acceleration at its start [m/s²]. */
  readonly a: number
  /** [s] */
  readonly lasts: number
}

// A block takes two phases to lose 4 μk g m/k of its amplitude, until it sticks for the first time.
const MOST_PHASES = 8192

/**
 * A block that a spring holds on a moving belt: stick and slip (Den Hartog, Mechanical Vibrations, on friction). While it
 * slides, with a the acceleration at the start and x = ωt,
 *
 *     s = s₀ + v₀ sin(x)/ω + a (1 − cos x)/ω²,   v = v₀ cos x + a sin(x)/ω
 *
 * up to v = u, where tan(x/2) is a root of a quadratic. Then it rides, up to k s = μs N. From the first release on the
 * motion repeats itself: it slides for 2(π − atan((μs − μk) g/(ωu)))/ω and rides for 2(μs − μk) g/(ω²u). NaN where it
 * takes thousands of swings to stick for the first time.
 */
export function exactBelt(parameters: {
  beltSpeed: number
  stiffness: number
  muStatic: number
  muKinetic: number
  gravity: number
  mass: number
  position: number
  speed: number
}): ExactMotion {
  const { beltSpeed, stiffness, muStatic, muKinetic, gravity, mass, position, speed } = parameters
  const belt = {
    speed: beltSpeed,
    stiffness: stiffness / mass,
    kinetic: muKinetic * gravity,
    static: Math.max(muStatic, muKinetic) * gravity,
  }
  const starts: number[] = []
  const phases: Phase[] = []
  const time = new ExactSum()
  let state: State = { s: position, v: speed }
  // When the spring tears the block off: from the second time on, the motion repeats.
  const releases: number[] = []
  let end = 0
  while (end < Infinity && releases.length < 2 && phases.length < MOST_PHASES) {
    const phase = phaseFrom(belt, state)
    starts.push(end)
    phases.push(phase)
    if (phase.lasts < Infinity) time.add(phase.lasts)
    end = phase.lasts < Infinity ? time.value : Infinity
    if (phase.rides) releases.push(end)
    state = endOf(belt, phase)
  }
  const [first, second] = releases

  return (t, into) => {
    let at = t
    if (second !== undefined && t > second) at = first! + ((t - first!) % (second - first!))
    let i = starts.length - 1
    while (i > 0 && starts[i]! > at) i--
    if (at <= end) return move(belt, phases[i]!, at - starts[i]!, into)
    return Object.assign(into, { s: NaN, v: NaN })
  }
}

/** The phase that begins at a state. */
function phaseFrom(belt: Belt, { s, v }: State): Phase {
  const { speed, stiffness, kinetic } = belt
  const drive = -stiffness * s
  const sticks = v === speed && frictionHolds(drive, belt.static, Math.abs(drive))
  if (sticks) {
    const release = (Math.sign(speed) * belt.static) / stiffness
    const lasts = (release - s) / speed
    // Exactly where static friction gives way, the block already slides.
    if (lasts > RELEASE * Math.abs(release / speed)) return { s, v, rides: true, a: 0, lasts }
  }
  const slip = Math.sign(v - speed || drive)
  const a = drive - slip * kinetic
  return { s, v, rides: false, a, lasts: timeToBelt(belt, v, a) }
}
const RELEASE = 8 * Number.EPSILON

/**
 * When a block that slides has the belt's speed: the first x > 0 with v₀ cos x + (a/ω) sin x = u, by x = 2 atan τ [s].
 */
function timeToBelt({ speed, stiffness }: Belt, v: number, a: number): number {
  const omega = Math.sqrt(stiffness)
  if (omega === 0) {
    const time = (speed - v) / a
    return time > 0 ? time : Infinity
  }
  const A = a / omega
  const square = A * A + (v - speed) * (v + speed)
  if (square < 0) return Infinity
  // (u + v₀) τ² − 2Aτ + (u − v₀) = 0
  const q = A + (A < 0 ? -1 : 1) * Math.sqrt(square)
  const angles = [Math.atan2(q, speed + v), Math.atan2(speed - v, q)]
    .map((half) => (half <= 0 ? half + Math.PI : half))
    .filter((half) => half < Math.PI || v !== speed)
  return (2 * Math.min(...angles)) / omega
}

function endOf(belt: Belt, phase: Phase): State {
  const end = move(belt, phase, phase.lasts, { s: NaN, v: NaN })
  if (phase.rides) end.s = (Math.sign(belt.speed) * belt.static) / belt.stiffness
  return { s: end.s, v: belt.speed }
}

function move(
  { speed, stiffness }: Belt,
  { s, v, a, rides }: Phase,
  t: number,
  into: State,
): State {
  const omega = Math.sqrt(stiffness)
  const x = omega * t
  const run = t * cardinal(Math.sin(x), x)
  const risen = t * cardinal(Math.sin(x / 2), x / 2)
  into.s = rides ? s + speed * t : s + v * run + 0.5 * a * risen * risen
  into.v = rides ? speed : v * Math.cos(x) + a * run
  return into
}
