import { html, nothing } from 'lit'
import { integrators } from '../../physics/index.ts'
import type {
  Evaluation,
  Integrator,
  PolicyStep,
  ResolvedExperiment,
  Stretch,
  TriedStep,
} from '../../physics/index.ts'
import { withoutRounding } from '../../measure/index.ts'
import { raw } from '../../chart/numbers.ts'
import { saidHtml, say } from './said.ts'
import type { Said } from './said.ts'
import { wordsAfter, wordsBefore } from './stepWords.ts'
import { written } from './written.ts'
import type { WrittenLine } from './written.ts'

/** A step of the timestep policy, written out. */
export function stepHtml(step: PolicyStep, experiment: ResolvedExperiment) {
  const { from, dt, stretches } = step
  return html`
    ${paragraph(say`The step begins at s = ${from.s} m with v = ${from.v} m/s and lasts Δt = ${dt} s.`)}
    ${wordsBefore(step, experiment).map(paragraph)}
    ${stretches.map(
      (stretch) => html`
        ${
          stretches.length > 1
            ? html`<h3 class="stretch">
                ${saidHtml(say`From ${stretch.begins} s of the step on`)}
              </h3>`
            : nothing
        }
        ${stretchHtml(stretch, experiment)} ${wordsAfter(step, stretch, experiment).map(paragraph)}
      `,
    )}
    ${stretches.length > 0 ? result(step) : nothing}
    ${
      step.outcome === 'at-rest' && ['fixed', 'substeps'].includes(experiment.timestep.kind)
        ? html`<p>If more steps are due in the frame, they have nothing to do.</p>`
        : nothing
    }
  `
}

function stretchHtml({ tries }: Stretch, experiment: ResolvedExperiment) {
  const method: Integrator = integrators.find(({ id }) => id === experiment.integrator)!
  const kept = tries[tries.length - 1]!
  return html`
    ${tries.length > 1 ? triesHtml(tries) : nothing} ${evaluationsHtml(kept, experiment)}
    ${written(method, kept).map(
      ({ heading, dt, lines }) => html`
        <h3>${method.label}, ${saidHtml(say`${heading} = ${dt} s`)}</h3>
        <div class="lines">${lines.map(lineHtml)}</div>
      `,
    )}
  `
}

/** The step lengths that were tried to end the step at the event; the last one was accepted. */
function triesHtml(tries: readonly TriedStep[]) {
  return html`<h3>Finding the instant</h3>
    <ol class="tries">
      ${tries.map(
        ({ dt, from, to }) =>
          html`<li>
            ${saidHtml(say`Δt = ${dt} s → s = ${to.s} m, v = `)}${worth(to.v, 'm/s', [from.v])}
          </li>`,
      )}
    </ol>`
}

/** Each evaluation of the forces: where it is made, and its result. */
function evaluationsHtml({ evaluations, reused, slip }: TriedStep, experiment: ResolvedExperiment) {
  const { muKinetic, beltSpeed = 0 } = experiment.parameters
  const hasFriction = (muKinetic ?? 0) > 0
  const direction = hasFriction
    ? `, slip direction ${slip === 0 ? 'by the sign of each v' : slip < 0 ? '−1' : '+1'}`
    : ''
  const first = reused === undefined ? 1 : 2
  const legend = hasFriction
    ? `drive: gravity${'stiffness' in experiment.parameters ? ' and spring' : ''} along the track. press: what presses the block onto it. Both per kilogram.`
    : 'drive: everything that acts along the track, per kilogram.'
  return html`<h3>Force evaluations${direction}</h3>
    <p class="legend">${legend}</p>
    <div class="lines">
      ${
        reused === undefined
          ? nothing
          : lineHtml({
              formula: 'a₁: from the step before',
              numbers: [],
              result: reused,
              unit: 'm/s²',
            })
      }
      ${evaluations.map((each, i) => lineHtml(evaluationLine(each, ordinal(first + i), slip || Math.sign(each.v - beltSpeed), hasFriction ? muKinetic : 0)))}
    </div>`
}

function evaluationLine(
  { s, v, drive, press, a }: Evaluation,
  index: string,
  slip: number,
  mu = 0,
) {
  const where = say`at s = ${s} m, v = ${v} m/s: `
  return {
    formula: mu > 0 ? `a${index} = drive − slip μk press` : `a${index} = drive`,
    numbers: mu > 0 ? say`${drive} − (${slip}) × ${mu} × ${press}` : say`${drive}`,
    result: a,
    unit: 'm/s²',
    where,
  }
}

function lineHtml({
  formula,
  numbers,
  result,
  unit,
  solved,
  where,
}: WrittenLine & { where?: Said }) {
  return html`<p>
    <span class="formula"
      >${where ? html`<small>${saidHtml(where)}</small>` : nothing}${saidHtml([formula])}</span
    >
    <span>
      <span class="numbers">${numbers.length > 0 ? html`= ${saidHtml(numbers)}` : nothing}</span>
      <span class="result">= ${worth(result, unit, numbers)}</span>
      ${solved ? html`<small>${saidHtml(solved)}</small>` : nothing}
    </span>
  </p>`
}

/** A sum that should be 0 rarely is in floating point: it is rounding beside the largest number in it. */
function worth(value: number, unit: string, numbers: Said) {
  const sizes = numbers.map((each) => (typeof each === 'number' ? Math.abs(each) : 0))
  return value !== 0 && withoutRounding(value, Math.max(...sizes, 0)) === 0
    ? html`<span title=${raw(value)}>0 (to rounding)</span>`
    : saidHtml(say`${value} ${unit}`)
}

function result({ to }: PolicyStep) {
  return html`<p class="end">${saidHtml(say`It ends at s = ${to.s} m with v = ${to.v} m/s.`)}</p>`
}

function paragraph(said: Said) {
  return html`<p>${saidHtml(said)}</p>`
}

/** A number as an index under the line: 12 as ₁₂. */
function ordinal(index: number): string {
  return String(index).replace(/\d/g, (digit) => '₀₁₂₃₄₅₆₇₈₉'[Number(digit)]!)
}
