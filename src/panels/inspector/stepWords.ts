import type {
  PolicyStep,
  ResolvedExperiment,
  Standing,
  Stretch,
  Trajectory,
} from '../../physics/index.ts'
import { roughSize } from '../../chart/magnitudes.ts'
import { clockworkOf } from '../../lab/state/clockwork.ts'
import { counted, say } from './said.ts'
import type { Said } from './said.ts'
import { triesIn } from './tries.ts'

/** How long the frame lasts that ends at a row [s]. */
export function frameLength({ time }: Trajectory, row: number): number {
  return rounded(time[row]! - time[row - 1]!)
}

/** By how much the game's time goes on in it [s]. */
function gameLength({ gameTime }: Trajectory, row: number): number {
  return rounded(gameTime[row]! - gameTime[row - 1]!)
}

/** A difference of times [s] without what rounding left in its last digits. */
function rounded(time: number): number {
  return Math.round(time * 1e12) / 1e12
}

/** How the timestep policy turned a frame into steps, where `steps` are those that had something to move. */
export function policyWords(run: Trajectory, row: number, steps: readonly PolicyStep[]): Said {
  const { frames, timeScale } = run.experiment
  const words = policyAlone(run, row, steps)
  if (!frames.delta && timeScale === 1) return words
  return say`The frame lasts ${frameLength(run, row)} s, and the game counts it as ${gameLength(run, row)} s. ${words}`
}

function policyAlone(run: Trajectory, row: number, steps: readonly PolicyStep[]): Said {
  const { experiment, outcome } = run
  const { timestep, timeScale } = experiment
  const lasts = gameLength(run, row)
  if (timestep.kind === 'tolerance') return toleranceWords(timestep.tolerance, steps)
  const ends = outcome.kind !== 'moving' && outcome.kind !== 'at-rest' && row === run.frames
  if (ends && steps.length > 0)
    return say`${counted(steps.length, 'step')} of ${steps[0]!.dt} s, until the run ended.`
  switch (timestep.kind) {
    case 'per-frame':
      return say`One step of ${timeScale * timestep.step} s, however long the frame was.`
    case 'variable':
      return say`One step, as long as the frame: ${lasts} s.`
    case 'capped':
      return lasts > timestep.cap
        ? say`One step of ${timestep.cap} s, the cap: the other ${rounded(lasts - timestep.cap)} s of the frame is lost.`
        : say`One step, as long as the frame: ${lasts} s is within the cap of ${timestep.cap} s.`
    case 'substeps': {
      const length = steps[0]?.dt
      if (length === undefined)
        return say`Equal parts of the frame, none longer than ${timestep.step} s.`
      const time = Math.min(lasts, rounded(timestep.step * timestep.maxSteps))
      const parts = counted(Math.round(time / length), 'equal part')
      return [
        ...say`${time} s → ${parts} of ${length} s, none longer than ${timestep.step} s.`,
        ...(time < lasts ? say` The other ${rounded(lasts - time)} s of the frame is lost.` : []),
      ]
    }
    case 'fixed':
      return fixedWords(run, row, timestep.step, timestep.cap)
  }
}

/** How many steps the frame took of those that were tried. */
function toleranceWords(tolerance: number, steps: readonly PolicyStep[]): Said {
  const tries = triesIn(steps)
  const refused = tries.filter(({ attempt }) => !attempt.accepted).length
  const kept = tries.length - refused
  const taken = refused === 0 ? '' : `, ${refused === 1 ? 'one is' : `${refused} are`} taken back`
  return say`An error of ${roughSize(tolerance)} is allowed in each second: ${kept === 1 ? '1 try is' : `${kept} tries are`} kept${taken}.`
}

/** What the accumulator held, what the frame paid in, and what was dropped: by the cap, and in whole steps. */
function fixedWords(run: Trajectory, row: number, step: number, cap: number): Said {
  const { accumulator, lost } = clockworkOf(run)
  const lasts = gameLength(run, row)
  const cut = Math.max(0, rounded(lasts - cap))
  const dropped = Math.round((lost[row]! - lost[row - 1]! - cut) / step)
  const taken = Math.round((run.stateTime[row]! - run.stateTime[row - 1]!) / step)
  const steps = counted(taken, 'fixed step')
  return [
    ...say`${rounded(accumulator[row - 1]!)} s in the accumulator + ${rounded(lasts - cut)} s → ${steps} of ${step} s, `,
    ...say`${rounded(accumulator[row]!)} s left in the accumulator.`,
    ...(cut > 0 ? say` The frame exceeds the cap: ${cut} s is lost.` : []),
    ...(dropped > 0
      ? say` ${counted(dropped, 'step')} more would have been due: ${rounded(dropped * step)} s is lost.`
      : []),
  ]
}

/** What the stopping rule found before the step of a block that stood still, if it did: whether it stays. */
export function wordsBefore(step: PolicyStep, experiment: ResolvedExperiment): Said[] {
  const [standing] = step.standings
  if (standing?.begins !== 0) return []
  const { beltSpeed = 0 } = experiment.parameters
  const how = beltSpeed === 0 ? 'is at rest' : 'has the belt’s speed'
  return [say`The block ${how}: ${decision(step, standing, experiment)}`]
}

/** What the stopping rule did at the end of a stretch, a sentence each. */
export function wordsAfter(
  step: PolicyStep,
  stretch: Stretch,
  experiment: ResolvedExperiment,
): Said[] {
  const kept = stretch.tries[stretch.tries.length - 1]!
  const isLast = stretch === step.stretches[step.stretches.length - 1]
  const said: Said[] = []
  if (experiment.stopping === 'located') {
    const ends = stretch.begins + kept.dt
    const tries = stretch.tries.length
    const when = say`after ${ends} s of ${step.asked} s${tries > 1 ? `, found in ${counted(tries, 'try', 'tries')}` : ''}`
    if (stretch.ends === 'stop') {
      const standing = step.standings.find(({ begins }) => begins === ends)
      const then = standing
        ? decision(step, standing, experiment)
        : say`the next step decides whether it stays.`
      const { beltSpeed = 0 } = experiment.parameters
      const reached = beltSpeed === 0 ? '0' : 'the belt’s speed'
      said.push(say`v reached ${reached} ${when}; s = ${kept.to.s} m; ${then}`)
    }
    if (stretch.ends === 'cut')
      said.push(
        say`The step is cut to ${kept.dt} s: over its whole length the force would change too much for a single step.`,
      )
    if (stretch.ends === 'halved')
      said.push(
        say`A trial came out faster than its start can pay for. The step is halved to ${kept.dt} s.`,
      )
    if (stretch.ends === 'take-off')
      said.push(say`The normal force reaches 0 at s = ${kept.to.s} m ${when}: the block takes off.`)
    if (stretch.ends === 'joint')
      said.push(say`The block reaches the joint at s = ${kept.to.s} m ${when}.`)
  } else if (isLast) {
    if (kept.to.v !== step.to.v)
      said.push(say`v would have been ${kept.to.v} m/s: set to ${step.to.v}.`)
    if (kept.to.s !== step.to.s)
      said.push(
        say`s would have been ${kept.to.s} m, behind where the step began: set back to ${step.to.s} m.`,
      )
    const { muKinetic = 0 } = experiment.parameters
    if (experiment.stopping === 'naive' && muKinetic > 0 && step.from.v * step.to.v < 0)
      said.push(
        say`v crossed 0, and nothing noticed. In the next step friction pushes the block back, so it trembles.`,
      )
  }
  if (isLast && step.outcome === 'left-the-track' && stretch.ends !== 'take-off')
    said.push(say`The track ends there: the block has left it.`)
  if (isLast && step.outcome === 'diverged')
    said.push(say`The step has lost its stability: the run has diverged and ends here.`)
  return said
}

/** Static friction holds up to μs times the normal force. */
function decision(step: PolicyStep, standing: Standing, { parameters }: ResolvedExperiment): Said {
  const { muStatic = 0, beltSpeed = 0 } = parameters
  const drive = Math.abs(standing.drive)
  const most = muStatic * standing.press
  const isLast = standing === step.standings[step.standings.length - 1]
  // On a belt a block that is held goes on, until the spring is stronger.
  const isHeld = beltSpeed === 0 ? isLast && step.outcome === 'at-rest' : drive <= most
  if (!isHeld) return say`it sets off, because |drive| ${drive} > μs press ${most} m/s².`
  const does = beltSpeed === 0 ? 'stays' : 'rides along'
  return say`it ${does}, because |drive| ${drive} ≤ μs press ${most} m/s².`
}
