import { html } from 'lit'
import type { PeerRun, Report } from '../../../report/schema.ts'
import { metres, raw } from '../../../chart/numbers.ts'
import { menu } from '../../../ui/menu.ts'

/** How far each engine ends from the truth, under a clock of the reader's choice. */
export function engineErrors(
  { peers, contestants }: Report,
  clock: string,
  choose: (clock: string) => void,
) {
  const engines = [...new Set(peers.runs.map(({ engine }) => engine))]
  const list = peers.clocks.map((id) => ({ id, label: id, about: `Frames: ${id}` }))
  return html`<label class="choose">
      Errors at
      ${menu({
        label: 'Frames of the engines’ errors',
        list,
        chosen: clock,
        pick: (id) => {
          choose(id)
          return true
        },
      })}
    </label>
    <div class="scroll" tabindex="0" role="region" aria-label="Engines, errors, table">
      <table>
        <caption>
          Distance from the true position at the end, at ${clock}
        </caption>
        <thead>
          <tr>
            <th scope="col">Engine</th>
            ${peers.scenes.map(
              ({ label, about }) => html`<th scope="col">${label}<small>${about}</small></th>`,
            )}
          </tr>
        </thead>
        <tbody>
          ${engines.map(
            (engine) =>
              html`<tr>
                <th scope="row">${contestants.find(({ id }) => id === engine)?.label ?? engine}</th>
                ${peers.scenes.map(({ id }) =>
                  cell(
                    peers.runs.find(
                      (run) => run.engine === engine && run.scene === id && run.clock === clock,
                    ),
                  ),
                )}
              </tr>`,
          )}
        </tbody>
      </table>
    </div>`
}

function cell(run: PeerRun | undefined) {
  if (!run) return html`<td>–</td>`
  const { error, note } = run
  return html`<td title=${error === null ? '' : `${raw(error)} m`}>
    ${error === null ? 'no number any more' : metres(Number(error.toPrecision(2)))}
    ${note ? html`<small>${note}</small>` : ''}
  </td>`
}
