import type { Integrator } from './integrator.ts'
import { FAR } from './law.ts'
import type { Motion } from './motion.ts'

/**
 * What ends a step early: the block turns (its sliding ends, v = u), comes to the end of its piece of track, or takes off
 * from a crest (press = 0). A block is fastest where the forces balance, and may turn there: that is looked at.
 */
type Event = 'turn' | 'joint' | 'take-off' | 'balance'

const MOST_HALVINGS = 60
const MOST_ITERATIONS = 100
// Nearer to a joint at s = 0 than this, a step would have a denormal length with next to no digits [m].
const NEAREST = 1e-300
// The rounding error of a residual with terms of size 1: each of a step's few hundred operations adds an ulp.
const ROUNDING = 1000 * Number.EPSILON

// A block that turns beyond a joint by no more than its position's rounding turns at the joint.
const TOUCH = 16 * Number.EPSILON

/**
 * Takes a step of `motion.dt`, or one that is shortened to end at the first event inside: at v = 0 exactly, or at the
 * joint exactly. Leaves its length in `motion.dt`. If no such step can be found, the motion ends as diverged.
 */
// #region event
export function stepToEvent(motion: Motion, integrator: Integrator): void {
  // No step is so long that a bend turns by more than two radians, or that the step could hold two turns.
  const changes = motion.dt * (motion.rate + motion.ratePerSpeed * Math.abs(motion.v))
  if (changes > 1) motion.dt /= Math.ceil(2 * changes)
  integrator.step(motion)
  const { turnMatters } = motion.law
  if (motion.law.belt !== 0 && mayHaveTouched(motion)) lookWhereFastest(motion, integrator)
  const turned = hasTurned(motion) && (turnMatters || mayReachEnd(motion))
  const overflowed = turnMatters && !(Math.abs(motion.v) < Infinity)
  if (turned || overflowed || isOutside(motion)) shortenToEvent(motion, integrator)
  if (motion.curvature < 0 && motion.moving && motion.isLifted()) takeOff(motion, integrator)
}
// #endregion

function hasTurned({ v, slip, law }: Motion): boolean {
  return slip > 0 ? v < law.belt : v > law.belt
}

function isOutside({ s, from, to }: Motion): boolean {
  return s > to || s < from
}

/** Ends a step at the first event in it. An implausible trial is halved first. */
function shortenToEvent(motion: Motion, integrator: Integrator): void {
  // Implausible however short the step: the motion has diverged.
  if (Math.abs(motion.s) >= FAR) return
  for (let i = 0; !isPlausible(motion); i++) {
    if (i === MOST_HALVINGS) return motion.end('diverged')
    retake(motion, integrator, 0.5 * motion.dt)
  }
  const { dt, slip, law } = motion
  const end = slip > 0 ? motion.to : motion.from
  const outside = isOutside(motion)
  if (hasTurned(motion) && (law.turnMatters || outside || mayReachEnd(motion))) {
    if (!locate('turn', motion, integrator)) return motion.end('diverged')
    const ahead = residual('joint', motion)
    if (ahead >= -TOUCH * Math.abs(end)) {
      // Where neither friction nor an end makes it matter, a turn is part of a step like any other.
      if (!law.turnMatters && !outside) return retake(motion, integrator, dt)
      motion.stop()
      if (ahead < 0) motion.s = end
      return
    }
  }
  // Of a turn and a joint the joint comes first: before a turn the block slides one way.
  if (residual('joint', motion) >= 0) return
  if (!locate('joint', motion, integrator)) return motion.end('diverged')
  motion.s = end
}

/** How far the motion is from an event, along the slip direction: negative beyond it [m/s, m, m/s²]. */
function residual(event: Event, motion: Motion): number {
  const { s, v, slip, from, to, law } = motion
  if (event === 'turn') return slip * (v - law.belt)
  if (event === 'joint') return slip > 0 ? to - s : s - from
  if (event === 'balance') return slip * (s - balanceOf(motion))
  motion.findPress()
  return motion.press
}

/**
 * Ends a step where the block takes off. Along a crest, press grows up to the top and falls beyond it; once below 0, it
 * keeps falling. So the sign at the step's end shows whether the block takes off, and it does so once at most.
 */
function takeOff(motion: Motion, integrator: Integrator): void {
  if (!locate('take-off', motion, integrator)) return motion.end('diverged')
  motion.end('left-the-track')
}

/** Where spring, gravity and friction balance a block that slides [m]. */
function balanceOf({ tangential, friction, weight, law }: Motion): number {
  return (tangential - friction * weight) / law.stiffness
}

/**
 * Whether a block that is slower than the belt at both ends of a trial may have been as fast as the belt between them: it
 * was fastest where the forces balance, with the speed that the energy of its swing allows.
 */
function mayHaveTouched(motion: Motion): boolean {
  const { s, startS, startV, slip, law } = motion
  const { belt, stiffness } = law
  if (slip * belt > 0 || hasTurned(motion)) return false
  const balance = balanceOf(motion)
  const swing = startS - balance
  const isPassed = slip * swing > 0 && slip * (s - balance) < 0
  return isPassed && startV * startV + stiffness * swing * swing > belt * belt
}

/** Ends a trial where the block is fastest, if it has turned by then; otherwise the trial stays. */
function lookWhereFastest(motion: Motion, integrator: Integrator): void {
  const { dt } = motion
  locate('balance', motion, integrator)
  if (!hasTurned(motion)) retake(motion, integrator, dt)
}

/** Takes the step again, now of `dt` seconds. */
function retake(motion: Motion, integrator: Integrator, dt: number): void {
  motion.rewind()
  motion.dt = dt
  integrator.step(motion)
}

/** Whether a trial's speed and distance are at most twice what the energy at its start allows: the step is stable. */
function isPlausible(motion: Motion): boolean {
  const { s, v, dt, slip, startS, tangential, curvature, law } = motion
  if (curvature === 0 && law.stiffness === 0 && law.drag === 0) return true
  // Air slows a block that gravity pulls along, but never turns it.
  if (law.drag > 0 && hasTurned(motion) && slip * tangential > 0) return false
  const most = 2 * fastest(motion)
  return Math.abs(v) <= most && Math.abs(s - startS) <= most * dt
}

/** The highest speed that the energy at the start of the step and its forces allow [m/s]. */
function fastest({ startS, startV, dt, tangential, weight, law }: Motion) {
  const { stiffness } = law
  if (stiffness === 0) return Math.abs(startV) + law.gravity * dt
  // The amplitude of the swing, from the distance to the point where spring, gravity and friction balance.
  const force = Math.abs(tangential - stiffness * startS) + law.muKinetic * weight
  return Math.abs(startV) + force / Math.sqrt(stiffness)
}

/** Whether a block without friction and drag may have crossed the end of its piece before it turned. */
function mayReachEnd(motion: Motion): boolean {
  const { startS, dt, slip, from, to } = motion
  return (slip > 0 ? to - startS : startS - from) <= fastest(motion) * dt
}

/**
 * Shortens a step that passed an event so that it ends there: finds the length for which the integrator's own step
 * from the same start ends at the event to rounding. Returns whether there is such a length.
 *
 * Regula falsi in the form of Anderson and Björck (1973), which keeps the root bracketed, with occasional bisections
 * so that the bracket is sure to close. Its tolerance comes from the start of the step and its length, never from the trial's end.
 */
function locate(event: Event, motion: Motion, integrator: Integrator): boolean {
  let late = motion.dt
  let after = residual(event, motion)
  motion.rewind()
  let early = 0
  let before = residual(event, motion)
  const size = sizeOf(event, motion)
  const small = Number.EPSILON * Math.max(size, before)
  const limit = ROUNDING * Math.max(size, before, event === 'turn' ? fastest(motion) : 0)
  // The press is 0 from the start, and falls; or the block is already at the joint.
  if (event === 'take-off' ? before <= 0 : event === 'joint' && before < NEAREST) {
    motion.dt = 0
    return true
  }
  // A block that has just set off starts at v = 0: look for the turn after that.
  for (let i = 0; before <= 0; i++) {
    if (i === MOST_HALVINGS) return false
    early = 0.5 * (i === 0 ? late : early)
    retake(motion, integrator, early)
    before = residual(event, motion)
  }
  let lastSide = 0
  for (let i = 1; i <= MOST_ITERATIONS; i++) {
    let length = early + ((late - early) * before) / (before - after)
    if (i % 8 === 0 || !(length > early && length < late)) length = early + 0.5 * (late - early)
    retake(motion, integrator, length)
    const here = residual(event, motion)
    if (Math.abs(here) <= small) return true
    if (late - early <= Number.EPSILON * late) return Math.abs(here) <= limit
    // An end that stays while the other moves twice gets less weight, so that it moves next.
    if (here > 0) {
      if (lastSide > 0) after *= lessWeight(here, before)
      early = length
      before = here
      lastSide = 1
    } else {
      if (lastSide < 0) before *= lessWeight(here, after)
      late = length
      after = here
      lastSide = -1
    }
  }
  return Math.abs(residual(event, motion)) <= limit
}

/** The size of the terms whose difference is the residual, for its rounding error [m/s, m, m/s²]. */
function sizeOf(event: Event, { slip, from, to, law }: Motion): number {
  if (event === 'turn') return Math.abs(law.belt)
  if (event === 'joint') return Math.abs(slip > 0 ? to : from)
  // Where it is fastest, the block needs no more than a place on the right side.
  return law.gravity
}

function lessWeight(here: number, before: number): number {
  const factor = 1 - here / before
  return factor > 0 ? factor : 0.5
}
