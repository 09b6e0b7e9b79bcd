import { amount, flag, list, number, orNull, recordOf, table, text, word } from './shape.ts'
import type { Shaped } from './shape.ts'

/** Nanoseconds: the median of all rounds, the quickest and the slowest one. */
const timing = recordOf({ median: amount, least: amount, most: amount })

/** Where the figures come from. */
const machine = recordOf({
  /** ISO 8601. */
  date: text,
  /** As the processor calls itself. */
  processor: text,
  cores: amount,
  system: text,
  node: text,
  v8: text,
  /** Rounds that each time was taken in. */
  rounds: amount,
  /** Few and short rounds: figures for trying out, not for showing. */
  quick: flag,
})

/** An engine or a solver that is compared, or ours. */
const engineInfo = recordOf({
  id: text,
  label: text,
  /** Of its package. */
  version: text,
  /** How it is set up: units, friction, sleeping; in a sentence. */
  setup: text,
})

/**
 * A scene and a method: a call of `run.frame` for each step beside the loop that somebody would write by hand for just
 * this.
 */
const frameTime = recordOf({
  scene: text,
  integrator: text,
  /** ns a frame of the handwritten loop. */
  handwritten: timing,
  /** ns a frame of ours, in a process that runs nothing else. */
  alone: timing,
  /** The same in a process that has run all scenes, methods and rules; null: was not measured. */
  mixed: orNull(timing),
  /** Median over rounds of ours divided by the handwritten loop's, each from the same round. */
  ratios: recordOf({ alone: amount, mixed: orNull(amount) }),
  /** Bytes a frame that are taken from the heap. */
  bytes: recordOf({ alone: amount, mixed: orNull(amount) }),
})

/** A scene for engines: an experiment that any rigid-body engine can be given. */
const engineScene = recordOf({
  id: text,
  label: text,
  /** In words: angle, friction, speed, how long. */
  about: text,
  /** Parameters of the scene `ramp`, with which the truth is computed. */
  parameters: table(number),
  /** The time at which positions are compared [s]. */
  duration: amount,
  /** Up to when it is watched for creep after that [s]; null: it is not. */
  watchedUntil: orNull(amount),
  /** Where the true motion is then [m]. */
  truth: number,
  /** Sliding has ended by then, and static friction holds. */
  rests: flag,
})

/** One engine in one scene under one clock. */
const engineRun = recordOf({
  /** As in `engines`. */
  engine: text,
  scene: text,
  /** “10 fps”, “jitter”. */
  clock: text,
  /** Distance along the slope from the start, where it ended [m]; null: not a finite number any more. */
  position: orNull(number),
  /** |position − truth| [m]. */
  error: orNull(amount),
  /** How far it went between the end and `watchedUntil` [m]; null where it is not watched. */
  creep: orNull(amount),
  /** The run's anomaly, in words; null: none. */
  note: orNull(text),
})

/** What a time step of an engine costs with one block sliding down one ramp. */
const engineTime = recordOf({
  engine: text,
  step: timing,
  /** How many calls of `run.frame`, with velocity Verlet and located stops, take as long; 1 for ours. */
  ratio: amount,
  /** Bytes a step that are taken from the JavaScript heap. */
  bytes: amount,
})

/** The coefficient of friction that an engine really has: from how fast it brakes on the flat at 60 fps. */
const frictionSeen = recordOf({ engine: text, asked: amount, seen: amount })

/** A method at one step length or one tolerance. */
const workPoint = recordOf({
  /** Step [s] of ours; tolerance of odex. */
  setting: amount,
  /** Root mean square of the position's error over the points that all are compared at [m]. */
  error: amount,
  /** Evaluations of the acceleration for each simulated second. */
  evaluations: amount,
  /** ns for each simulated second. */
  time: amount,
})

const workCurve = recordOf({
  /** An integrator's id, or `odex`. */
  id: text,
  label: text,
  /** Stopping rule of ours; null for odex. */
  stopping: orNull(text),
  /** Place in the palette; null: ink. */
  colour: orNull(amount),
  /** Slope of log error over log step, fitted where the error is neither rounding nor nonsense; null: too few points. */
  order: orNull(number),
  points: list(workPoint),
})

/** The cheapest way of a method to an error, interpolated on its curve; null where the curve does not get there. */
const cheapest = recordOf({ id: text, label: text, evaluations: amount, time: amount })

/** Speed against error for one experiment. */
const frontier = recordOf({
  id: text,
  label: text,
  about: text,
  /** [s] */
  duration: amount,
  curves: list(workCurve),
  /** Who gets to an error [m] at the lowest cost. */
  at: list(
    recordOf({
      error: amount,
      /** Ours with the fewest evaluations, and ours that is quickest. */
      fewest: orNull(cheapest),
      quickest: orNull(cheapest),
      odex: orNull(cheapest),
    }),
  ),
})

/** What methods that choose their own steps spend on an error, each in evaluations for a simulated second. */
const controlled = recordOf({
  id: text,
  label: text,
  about: text,
  at: list(
    recordOf({
      /** The largest of the run [m]. */
      error: amount,
      /** The best of ours to tolerance; null: none gets there. */
      ours: orNull(recordOf({ label: text, evaluations: amount })),
      odex: orNull(amount),
    }),
  ),
})

/** What was asked for, and what came out. */
const target = recordOf({
  id: text,
  label: text,
  /** The figure must be at most or at least `limit`. */
  sense: word('at most', 'at least'),
  limit: number,
  figure: number,
  met: flag,
  /** Where the figure comes from: the worst scene and method, or the nearest engine. */
  from: text,
})

const diagram = recordOf({ file: text, title: text, description: text })

const shape = recordOf({
  machine,
  engines: list(engineInfo),
  frames: list(frameTime),
  engineTests: recordOf({
    scenes: list(engineScene),
    clocks: list(text),
    runs: list(engineRun),
    times: list(engineTime),
    friction: list(frictionSeen),
  }),
  frontiers: list(frontier),
  controlled: list(controlled),
  targets: list(target),
  diagrams: list(diagram),
  /** What could not be run, and why. */
  notRun: list(recordOf({ what: text, why: text })),
})

export type Timing = Shaped<typeof timing>
export type Machine = Shaped<typeof machine>
export type EngineInfo = Shaped<typeof engineInfo>
export type FrameTime = Shaped<typeof frameTime>
export type EngineScene = Shaped<typeof engineScene>
export type EngineRun = Shaped<typeof engineRun>
export type EngineTime = Shaped<typeof engineTime>
export type FrictionSeen = Shaped<typeof frictionSeen>
export type WorkPoint = Shaped<typeof workPoint>
export type WorkCurve = Shaped<typeof workCurve>
export type Cheapest = Shaped<typeof cheapest>
export type Frontier = Shaped<typeof frontier>
export type Controlled = Shaped<typeof controlled>
export type Target = Shaped<typeof target>
export type Diagram = Shaped<typeof diagram>

/**
 * Everything that `npm run report` measured: the content of `public/report/report.json`. Times in ns, the rest in SI
 * units.
 */
export type Report = Shaped<typeof shape>

/**
 * What is wrong with a report, a line for every wrong place: “engineTests.runs[3].error: -1 is not a number of 0 or
 * more”.
 */
export function reportProblems(value: unknown): string[] {
  const problems: string[] = []
  shape.check(value, 'report', problems)
  return problems
}
