import { html } from 'lit'
import { repeat } from 'lit/directives/repeat.js'
import type { ChoiceOption, ListOption, Option, Options } from '../../physics/index.ts'
import { writeNumber } from '../../chart/numbers.ts'
import { readTyped, typedItems } from '../../chart/typedNumber.ts'
import '../../ui/quantityControl.ts'
import { summaryText } from '../../lab/state/frameTimes.ts'

interface OptionFields {
  /** Whose options they are. */
  readonly of: string
  readonly options: Options
  readonly values: Readonly<Record<string, unknown>>
  /** Answers with what is wrong with a value, or with nothing. */
  readonly pick: (key: string, value: unknown) => string
}

/** A field for each option of a list's entry, whatever the entry is. */
export function optionFields({ of, options, values, pick }: OptionFields) {
  return repeat(
    Object.entries(options),
    ([key]) => key,
    ([key, option]) => field(of, key, option, values[key], (value) => pick(key, value)),
  )
}

function field(
  of: string,
  key: string,
  option: Option,
  value: unknown,
  pick: (value: unknown) => string,
) {
  if (option.type === 'choice') return choiceField(of, option, value as string, pick)
  if (option.type === 'list') return timesField(of, option, value as readonly number[], pick)
  return html`<slide-quantity-control
    layout=${key === 'fps' ? 'bare' : 'inline'}
    .quantity=${option}
    .value=${value as number}
    .labelled=${of}
    .pick=${pick}
  ></slide-quantity-control>`
}

function choiceField(
  of: string,
  { label, choices }: ChoiceOption,
  chosen: string,
  pick: (value: unknown) => string,
) {
  return html`<label class="choice">
    ${label}
    <select
      aria-label="${label}, ${of}"
      @change=${(event: Event) => pick((event.target as HTMLSelectElement).value)}
    >
      ${choices.map(
        (choice) => html`<option value=${choice} .selected=${choice === chosen}>${choice}</option>`,
      )}
    </select>
  </label>`
}

/** Nobody reads more of them in a field, and writing them takes a while at every change. */
const MOST_TYPED = 2000

/** Frame times, the only lists there are: how many, and unfolded all of them, with blanks or commas between. */
function timesField(
  of: string,
  { label, unit }: ListOption,
  times: readonly number[],
  pick: (value: unknown) => string,
) {
  const changed = (event: Event) => {
    const { value } = event.target as HTMLInputElement
    pick(typedItems(value).map((item) => readTyped(item, unit) ?? item))
  }
  const field = () =>
    html`<label class="choice">
      ${label} [${unit}]
      <input
        type="text"
        aria-label="${label} [${unit}], ${of}"
        autocomplete="off"
        spellcheck="false"
        .value=${times.map(writeNumber).join(' ')}
        @change=${changed}
      />
    </label>`
  return html`<details class="times">
    <summary title=${summaryText(times)}>
      ${times.length} ${times.length === 1 ? 'frame' : 'frames'}
    </summary>
    ${times.length > MOST_TYPED ? html`<p>Too many to be typed.</p>` : field()}
  </details>`
}
