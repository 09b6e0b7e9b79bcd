import { integrators } from '../../src/physics/index.ts'
import type { Experiment, FramesChoice } from '../../src/physics/index.ts'

/** Every method that crosses a joint or a stop without losing its order. */
export const secondOrder = integrators.filter(({ order }) => order >= 2).map(({ id }) => id)

/** Seeded uniform numbers: mulberry32 (Tommy Ettinger, 2017), not the generator of the clocks that are tested. */
export class Chance {
  private state: number

  constructor(seed: number) {
    this.state = seed | 0
  }

  /** Uniform in [low, high). */
  between(low: number, high: number): number {
    this.state = (this.state + 0x6d2b79f5) | 0
    let bits = Math.imul(this.state ^ (this.state >>> 15), 1 | this.state)
    bits = (bits + Math.imul(bits ^ (bits >>> 7), 61 | bits)) ^ bits
    return low + (high - low) * (((bits ^ (bits >>> 14)) >>> 0) / 4294967296)
  }

  /** Log-uniform in [low, high). */
  scale(low: number, high: number): number {
    return Math.exp(this.between(Math.log(low), Math.log(high)))
  }

  /** True in this share of the calls. */
  share(part: number): boolean {
    return this.between(0, 1) < part
  }

  of<T>(list: readonly T[]): T {
    return list[Math.floor(this.between(0, list.length))]!
  }

  seed(): number {
    return Math.floor(this.between(0, 4294967296))
  }
}

function list<T>(count: number, seed: number, make: (chance: Chance) => T): T[] {
  const chance = new Chance(seed)
  return Array.from({ length: count }, () => make(chance))
}

/**
 * Run-outs whose bend is much shorter than the way of one long frame. bendRadius log-uniform 0.01 … 0.3 m, angle 5 … 90°,
 * length 0.5 … 8 m; muKinetic = muStatic, 0 in three of ten, else up to 0.5; position from 2 m above the slope's
 * beginning to the bend; from rest in a quarter, kicked uphill in a quarter, else downhill, at up to 12 m/s. Frames:
 * 30 … 144 fps with a hitch of 0.25 … 2 s every 0.3 … 1 s. Duration 2 … 5 s. The method is for the test to add.
 */
export function shortBends(count: number, seed: number): Experiment[] {
  return list(count, seed, (chance) => {
    const length = chance.between(0.5, 8)
    const mu = chance.share(0.3) ? 0 : chance.between(0, 0.5)
    const start = chance.between(0, 1)
    const speed = start < 0.25 ? 0 : chance.between(0, 12) * (start < 0.5 ? -1 : 1)
    return {
      scene: 'run-out',
      parameters: {
        angle: chance.between(5, 90),
        length,
        bendRadius: chance.scale(0.01, 0.3),
        muStatic: mu,
        muKinetic: mu,
        position: chance.between(-2, length),
        speed,
      },
      frames: hitches(chance, 0.25, 2),
      duration: chance.between(2, 5),
    }
  })
}

/** 30 … 144 fps with a hitch every 0.3 … 1 s that lasts as long as is said [s]. */
export function hitches(chance: Chance, shortest: number, longest: number): FramesChoice {
  return {
    kind: 'hitch',
    fps: chance.between(30, 144),
    every: chance.between(0.3, 1),
    length: chance.between(shortest, longest),
  }
}

export interface LipCase {
  experiment: Experiment
  /** By how much the energy exceeds what the lip needs, relative to that; negative where it falls short. */
  excess: number
  /** The longest step, in units of 1/ω with ω = √(g/R): half a swing is π. */
  longest: number
}

const GRAVITY = 9.81

/**
 * Half-pipes without friction whose block has a little more or less energy than its lip needs: relative excess
 * ±(1e-3 … 0.5), log-uniform. Radius 0.2 … 5 m, log-uniform; position within 0.99 of the way to either lip, so far as that
 * energy reaches; both directions. Frames: steady 5 … 240 fps, jitter of 0.1 … 0.9 about that, or hitches of 0.1 … 2 s;
 * redrawn until one step holds less than half a swing, ω dt < π. Duration: three swings of small amplitude, which is more
 * than one to and fro of these.
 */
export function lips(count: number, seed: number): LipCase[] {
  return list(count, seed, (chance) => lip(chance, chance.scale(1e-3, 0.5)))
}

/** The same within ±(1e-10 … 1e-8) of what the lip needs. */
export function grazingLips(count: number, seed: number): LipCase[] {
  return list(count, seed, (chance) => lip(chance, chance.scale(1e-10, 1e-8)))
}

function lip(chance: Chance, size: number): LipCase {
  const excess = chance.share(0.5) ? size : -size
  const radius = chance.scale(0.2, 5)
  const slope = highest(chance, excess)
  // Kinetic energy per g R: what is there in all, 1 + excess, less the potential 1 − cos.
  const kinetic = excess + Math.cos(slope)
  const speed = Math.sqrt(2 * GRAVITY * radius * kinetic) * (chance.share(0.5) ? 1 : -1)
  const omega = Math.sqrt(GRAVITY / radius)
  let frames = lipFrames(chance)
  while (omega * longestFrame(frames) >= Math.PI) frames = lipFrames(chance)
  return {
    experiment: {
      scene: 'half-pipe',
      parameters: { radius, gravity: GRAVITY, position: radius * slope, speed },
      frames,
      duration: (6 * Math.PI) / omega,
    },
    excess,
    longest: omega * longestFrame(frames),
  }
}

/**
 * Blocks just below the lip, moving to it, whose first step would carry them over it and back: relative excess 1e-6 … 0.1,
 * log-uniform, 0.2 … 2 times that, in radians, below the lip, radius 0.5 … 5 m. Without its lip the pipe would have them
 * back at their start after some 2v/g; the first frame lasts 1 … 1.5 times that, the second as long.
 */
export function overAndBack(count: number, seed: number): LipCase[] {
  return list(count, seed, (chance) => {
    const excess = chance.scale(1e-6, 0.1)
    const radius = chance.scale(0.5, 5)
    const side = chance.share(0.5) ? 1 : -1
    const slope = Math.PI / 2 - chance.scale(0.2, 2) * excess
    const speed = Math.sqrt(2 * GRAVITY * radius * (excess + Math.cos(slope)))
    const frame = (chance.between(1, 1.5) * 2 * speed) / GRAVITY
    return {
      experiment: {
        scene: 'half-pipe',
        parameters: {
          ...{ radius, gravity: GRAVITY },
          position: side * radius * slope,
          speed: side * speed,
        },
        frames: { kind: 'recorded', durations: [frame] },
        duration: 2 * frame,
      },
      excess,
      longest: Math.sqrt(GRAVITY / radius) * frame,
    }
  })
}

/** An angle from the bottom that a block of this energy can be at. */
function highest(chance: Chance, excess: number): number {
  const lip = (0.99 * Math.PI) / 2
  const most = excess < 0 ? Math.min(lip, 0.99 * Math.acos(-excess)) : lip
  return chance.between(-most, most)
}

function lipFrames(chance: Chance): FramesChoice {
  const fps = chance.scale(5, 240)
  const kind = chance.between(0, 3)
  if (kind < 1) return { kind: 'steady', fps }
  if (kind < 2)
    return { kind: 'jitter', fps, amount: chance.between(0.1, 0.9), seed: chance.seed() }
  return { kind: 'hitch', fps, every: chance.between(0.3, 1), length: chance.scale(0.1, 2) }
}

/** The longest frame that a clock can give [s]. */
function longestFrame(frames: FramesChoice): number {
  if (frames.kind === 'steady') return 1 / frames.fps
  if (frames.kind === 'jitter') return (1 + frames.amount) / frames.fps
  if (frames.kind === 'hitch') return Math.max(frames.length, 1 / frames.fps)
  throw new Error(`No bound is known for ${frames.kind}.`)
}

/**
 * Bends from rest, where a series' odd coefficients are 0: run-outs of any multiple of 15° in a half, else 5 … 90°;
 * bendRadius 0.05 … 5 m, log-uniform; from the first joint in a third, from inside the bend in a third, else from 0 … 4 m
 * above it; muKinetic = muStatic, 0 in a half, else up to 0.9 of what would hold the block at its start. Duration 1 … 5 s.
 * At the default frames.
 */
export function bendsFromRest(count: number, seed: number): Experiment[] {
  return list(count, seed, (chance) => {
    const angle = chance.share(0.5) ? 15 * Math.ceil(chance.between(0, 6)) : chance.between(5, 90)
    const bendRadius = chance.scale(0.05, 5)
    const from = chance.between(0, 3)
    const inside = from >= 1 && from < 2 ? chance.between(0.05, 0.9) : 0
    const length = from < 2 ? 0 : chance.between(0, 4)
    const slope = (angle * (1 - inside) * Math.PI) / 180
    const mu = chance.share(0.5) ? 0 : chance.between(0, 0.9) * Math.min(1, Math.tan(slope))
    return {
      scene: 'run-out',
      parameters: {
        ...{ angle, length, bendRadius, muStatic: mu, muKinetic: mu },
        position: inside * bendRadius * ((angle * Math.PI) / 180),
      },
      duration: chance.between(1, 5),
    }
  })
}

/** How a block meets two or more events in one step. */
export type Meeting =
  | 'foot, then stop'
  | 'uphill over the joint, turn, and back'
  | 'turn, then joint'
  | 'joint, then foot'

export const meetings: readonly Meeting[] = [
  'foot, then stop',
  'uphill over the joint, turn, and back',
  'turn, then joint',
  'joint, then foot',
]

/**
 * Run-outs whose first frame holds two events or three: radius 0.5 … 3 m, angle 15 … 75°, length 1 m. Frames of
 * ω dt = 0.4 … 1 with ω = √(g/R), three of them. muKinetic = muStatic: 0.3 … 0.8 where it is to stop, else 0 in a half and
 * up to half of tan(angle).
 */
export function meetingsInOneStep(meeting: Meeting, count: number, seed: number): Experiment[] {
  return list(count, seed, (chance) => {
    const radius = chance.scale(0.5, 3)
    const time = Math.sqrt(radius / GRAVITY)
    const frame = chance.between(0.4, 1) * time
    const steep = chance.between(15, 75)
    const angle = meeting === 'joint, then foot' ? chance.between(3, 10) : steep
    const slope = (angle * Math.PI) / 180
    const stops = meeting === 'foot, then stop'
    const mu = stops
      ? chance.between(0.3, 0.8)
      : chance.share(0.5)
        ? 0
        : chance.between(0, 0.5) * Math.tan(slope)
    const foot = 1 + radius * slope
    // How fast gravity and friction slow a block that goes up near the joint, or slides on the flat [m/s²].
    const slowing = stops ? mu * GRAVITY : GRAVITY * (Math.sin(slope) + mu * Math.cos(slope))
    // What it loses in a quarter to a half of the frame, so that the turn is well inside.
    const speed = chance.between(0.2, 0.45) * frame * slowing
    const start = {
      'foot, then stop': { position: foot - chance.between(0.02, 0.1) * speed * frame, speed },
      'uphill over the joint, turn, and back': {
        position: 1 + chance.between(0.02, 0.1) * speed * frame,
        speed: -speed,
      },
      'turn, then joint': {
        position: 1 - chance.between(0.02, 0.1) * speed * frame,
        speed: -speed,
      },
      'joint, then foot': {
        position: 1 - chance.between(0.05, 0.2) * radius * slope,
        speed: (chance.between(1.3, 2) * radius * slope) / frame,
      },
    }[meeting]
    return {
      scene: 'run-out',
      parameters: {
        ...{ angle, length: 1, bendRadius: radius, muStatic: mu, muKinetic: mu },
        ...start,
      },
      frames: { kind: 'recorded', durations: [frame] },
      duration: 3 * frame,
    }
  })
}
