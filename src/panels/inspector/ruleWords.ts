import type { PolicyStep, ResolvedExperiment, Standing, Stretch } from '../../physics/index.ts'
import { count, say } from './said.ts'
import type { Said } from './said.ts'

/** What the stopping rule found before the step of a block that stood still, if it did: whether it stays. */
export function wordsBefore(step: PolicyStep, experiment: ResolvedExperiment): Said[] {
  const [standing] = step.standings
  if (standing?.begins !== 0) return []
  return [say`It stands still: ${decision(step, standing, experiment)}`]
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
    const when = say`after ${ends} s of ${step.dt} s${tries > 1 ? `, found in ${count(tries, 'try').replace('trys', 'tries')}` : ''}`
    if (stretch.jump === 'stop') {
      const standing = step.standings.find(({ begins }) => begins === ends)
      const then = standing
        ? decision(step, standing, experiment)
        : say`whether it stays is decided as the next step begins.`
      said.push(say`v reached 0 ${when}; s = ${kept.to.s} m; ${then}`)
    }
    if (stretch.jump === 'joint')
      said.push(say`It came to the joint at s = ${kept.to.s} m ${when}.`)
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
        say`v went through 0 and came out on the other side. Nothing notices: in the next step friction pushes it back, and so it trembles.`,
      )
  }
  if (isLast && step.outcome === 'left-the-track')
    said.push(say`There the track ends: it has left.`)
  if (isLast && step.outcome === 'diverged')
    said.push(
      say`No real motion gets so fast or so far: the step has lost its stability, and the run ends.`,
    )
  return said
}

/** Static friction holds up to μs times the normal force. */
function decision(step: PolicyStep, standing: Standing, { parameters }: ResolvedExperiment): Said {
  const { muStatic = 0, muKinetic = 0 } = parameters
  const drive = Math.abs(standing.drive)
  const most = Math.max(muStatic, muKinetic) * standing.press
  const isLast = standing === step.standings[step.standings.length - 1]
  return isLast && step.outcome === 'at-rest'
    ? say`it stays, because |drive| ${drive} ≤ μs press ${most} m/s².`
    : say`it sets off, because |drive| ${drive} > μs press ${most} m/s².`
}
