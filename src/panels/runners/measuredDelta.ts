import { html, nothing } from 'lit'
import { measuring } from '../../physics/index.ts'
import { menu } from '../../ui/menu.ts'
import type { LabView } from '../../lab/labView.ts'
import { optionFields } from './optionFields.ts'

type Delta = (typeof measuring.delta.choices)[number]

/** What a game can take for the length of a frame, and what its players see of that. */
const deltas: readonly { readonly id: Delta; readonly label: string; readonly about: string }[] = [
  {
    id: 'exact',
    label: 'As shown',
    about:
      'The game moves by just as long as each frame is shown. Real timers don’t tell it so well.',
  },
  {
    id: 'rounded',
    label: 'Whole milliseconds',
    about:
      'A timer that counts milliseconds: 16.7 ms become 17, and at a steady 60 fps the game runs 2 % fast. Above 2000 fps it stands still.',
  },
  {
    id: 'mean',
    label: 'Mean of the last',
    about:
      'A smoothed delta: after a long frame the block is behind, and catches up over the next frames. In the end no time is lost.',
  },
  {
    id: 'snapped',
    label: 'Snapped to the display',
    about:
      'Rounded to whole refreshes of the display that the game expects. On any other display it runs fast or slow.',
  },
  {
    id: 'late',
    label: 'One frame late',
    about:
      'The length of the frame before, which is all that a loop knows. Steady frames are a frame behind; where their length changes, the block jerks.',
  },
]

/** The option that belongs to each choice, besides it. */
const belongs: { readonly [Id in Delta]?: 'meanOf' | 'snapTo' } = {
  mean: 'meanOf',
  snapped: 'snapTo',
}

/** What the selected runner's game takes for delta time. */
export function measuredDelta({ simulated, selected, change }: LabView) {
  const { state, name } = simulated.runners[selected]!
  const { delta = measuring.delta.initial, ...frames } = state.frames
  const pick = (key: string, value: unknown) =>
    change({ kind: 'option', index: selected, of: 'frames', key, value })
  const key = belongs[delta]
  return html`<div class="delta">
    <dt>
      ${measuring.delta.label}
      ${menu({
        label: `${measuring.delta.label}, ${name}`,
        list: deltas,
        chosen: delta,
        pick: (id) => pick('delta', id) === '',
      })}
    </dt>
    <dd>
      ${deltas.find(({ id }) => id === delta)!.about}
      ${
        key
          ? optionFields({
              of: name,
              options: { [key]: measuring[key] },
              values: { [key]: frames[key] ?? measuring[key].initial },
              pick,
            })
          : nothing
      }
    </dd>
  </div>`
}
