import type { Experiment, Trajectory } from '../physics/index.ts'
import { fixed, seconds } from '../chart/numbers.ts'
import { write } from '../chart/text.ts'
import { rateControl } from './shared/control.ts'
import { figure } from './shared/figure.ts'
import type { DrawingSurface, View } from './shared/figure.ts'
import { drawRuns } from './shared/scenePanel.ts'

/** Long enough for the highest frame rate [s]. */
const DURATION = 12

interface FlungValues {
  readonly fps: number
}

/** A block thrown out of a half-pipe by its own method. */
export const flungOut = figure({
  id: 'flung-out',
  title: 'Thrown out by its own method',
  pictured:
    'A block swings in a half-pipe without friction, a little higher each time, until it flies over the edge; a clock counts the seconds.',
  controls: {
    fps: rateControl(60, 10),
  },
  experiments: ({ fps }): Experiment[] => [
    {
      scene: 'half-pipe',
      parameters: { position: 2.6 },
      integrator: 'explicit-euler',
      frames: { kind: 'steady', fps },
      duration: DURATION,
    },
  ],
  duration: () => DURATION,
  opensAtStart: true,
  panels: [{ shape: { wide: 0.5, narrow: 0.8 }, draw }],
  says: ({ fps }, [run], time) => {
    const at = flownAt(run!)
    if (time < (at ?? DURATION))
      return `After ${fixed(time, 1)} s at ${fps} fps it is still in the pipe.`
    return at === undefined
      ? `At ${fps} fps it is still in the pipe after ${DURATION} s, and higher than it began.`
      : `At ${fps} fps explicit Euler throws it out after ${seconds(at)}. More frames do not help: they only make it take longer.`
  },
})

/** When a block left the pipe [s]. */
function flownAt({ outcome }: Trajectory): number | undefined {
  return outcome.kind === 'left-the-track' ? outcome.time : undefined
}

function draw(surface: DrawingSurface, { values, runs, time }: View<FlungValues>): void {
  const { context, width, height, palette } = surface
  drawRuns(surface, runs, [`${values.fps} fps`], time)
  const at = flownAt(runs[0]!)
  const gone = at !== undefined && time >= at
  context.font = `${width < 480 ? 34 : 52}px ${palette.serif}`
  context.fillStyle = gone ? palette.wrong : palette.ink
  const [x, y] = [0.5 * width, 0.5 * height]
  write(context, `${fixed(gone ? at : time, 1)} s`, x, y, {
    align: 'center',
    halo: palette.sheet,
  })
  context.font = `13px ${palette.sans}`
  const words = gone ? 'and out it flies' : 'and still in the pipe'
  write(context, words, x, y + 24, { align: 'center', halo: palette.sheet })
}
