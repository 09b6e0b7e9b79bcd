import { parseExperiment } from '../../physics/index.ts'
import type { Experiment, SceneId } from '../../physics/index.ts'
import type { Method } from '../../measure/index.ts'
import type { LabView } from '../../lab/labView.ts'
import { preset } from '../../lab/presets/preset.ts'
import { isAtHome, site } from '../../lab/site.ts'
import { linkTo, writeAddress } from '../../lab/state/address.ts'
import { checked } from '../../lab/state/check.ts'
import { openingOf } from '../../lab/state/opening.ts'
import type { LabState } from '../../lab/state/state.ts'

/** A run that was measured, and what was measured of it, in words. */
export interface Measured {
  readonly experiment: Experiment
  readonly label: string
  readonly words: string
}

/** Shows a measured run in a lab, as one change: the selected runner becomes it, the others stay. */
export function loadInto(lab: LabView, { experiment, label, words }: Measured): void {
  const { state } = lab.simulated
  const { scene, parameters, duration, timeScale, ...own } = parseExperiment(experiment)
  const runners = state.runners.map((runner, i) =>
    i === lab.selected ? { ...runner, ...own, hidden: false } : runner,
  )
  const next: LabState = { scene, parameters, duration, timeScale, runners }
  lab.load(preset('', label, words, () => checked(next), state))
}

/** Shows a scene in a lab with one method for all of its runners, as one change. */
export function loadMethod(
  lab: LabView,
  scene: SceneId,
  method: Method,
  { label, words }: Pick<Measured, 'label' | 'words'>,
): void {
  const { state } = lab.simulated
  const shown = scene === state.scene ? state : openingOf(scene)
  const runners = state.runners.map((runner) => ({ ...runner, ...method }))
  lab.load(preset('', label, words, () => checked({ ...shown, runners }), state))
}

/** Has the page's own lab show it, by way of the address; in another's page, the lab in a page of its own. */
export function loadByAddress({ experiment }: Measured): void {
  const { scene, parameters, duration, timeScale, ...own } = parseExperiment(experiment)
  const start = openingOf(scene)
  const runners = [{ ...start.runners[0]!, ...own }]
  const state = { ...start, parameters, duration, timeScale, runners }
  const home = site()
  if (isAtHome()) location.hash = writeAddress(state)
  else if (home !== null) open(linkTo('index.html', home, state), '_blank', 'noopener')
}
