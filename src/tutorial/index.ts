import { copyButton, reachable } from './page/code.ts'
import { followReader } from './page/contents.ts'
import { dial } from './page/dial.ts'
import { openWhatIsSought } from './page/folds.ts'
import { followLinks, highlight } from './page/figures.ts'
import { layOutInTurn } from './page/layOut.ts'
import { tabs } from './page/tabs.ts'

/* The text is there without any of this. */

const all = (selector: string) => [
  ...document.querySelectorAll<HTMLElement>(`.tutorial ${selector}`),
]

for (const contents of all('.contents')) followReader(contents)
for (const text of all('.text')) {
  followLinks(text)
  highlight(text)
}
all('.dial').forEach(dial)
all('.code').forEach(copyButton)
all('.take-home').forEach(tabs)
reachable(all(':is(pre, .equation, .table)'))
for (const text of all('.text')) openWhatIsSought(text)
layOutInTurn(all('.text > section'))
