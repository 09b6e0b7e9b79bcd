/** Turns listings that stand one after another into tabs, a tab a language, with a choice of dimensions before them. */
export function tabs(group: HTMLElement): void {
  const panels = [...group.children] as HTMLElement[]
  const wordsOf = (panel: HTMLElement) => panel.querySelector('.tab')!.textContent.split(', ')
  const distinct = (place: number) => [...new Set(panels.map((panel) => wordsOf(panel)[place]!))]
  const [languages, dimensions] = [distinct(0), distinct(1)]
  let [language, dimension] = [0, 0]
  const bar = document.createElement('div')
  bar.className = 'listing-choices'
  const choices = labelled(bar, 'group', 'Dimensions')
  const list = labelled(bar, 'tablist', 'Language')
  const pressed = dimensions.map((name, i) => button(choices, name, () => show(language, i)))
  const buttons = languages.map((name, i) => {
    const tab = button(list, name, () => show(i, dimension))
    tab.role = 'tab'
    tab.id = `take-home-tab-${i}`
    tab.addEventListener('keydown', ({ key }) => {
      const step = { ArrowRight: 1, ArrowLeft: -1 }[key]
      if (!step) return
      const next = (i + step + languages.length) % languages.length
      show(next, dimension)
      buttons[next]!.focus()
    })
    return tab
  })
  for (const panel of panels) {
    const place = languages.indexOf(wordsOf(panel)[0]!)
    panel.role = 'tabpanel'
    panel.setAttribute('aria-labelledby', buttons[place]!.id)
    panel.querySelector<HTMLElement>('.tab')!.hidden = true
  }
  const show = (chosenLanguage: number, chosenDimension: number) => {
    ;[language, dimension] = [chosenLanguage, chosenDimension]
    const name = `${languages[language]!}, ${dimensions[dimension]!}`
    const shown = panels.find((panel) => wordsOf(panel).join(', ') === name)!
    for (const panel of panels) panel.hidden = panel !== shown
    pressed.forEach((each, i) => (each.ariaPressed = String(i === dimension)))
    buttons.forEach((tab, i) => {
      tab.ariaSelected = String(i === language)
      tab.tabIndex = i === language ? 0 : -1
      tab.setAttribute('aria-controls', shown.id)
    })
  }
  group.prepend(bar)
  show(0, 0)
}

function labelled(parent: HTMLElement, role: string, name: string): HTMLElement {
  const element = document.createElement('div')
  element.role = role
  element.ariaLabel = name
  parent.append(element)
  return element
}

function button(parent: HTMLElement, name: string, act: () => void): HTMLButtonElement {
  const element = document.createElement('button')
  element.type = 'button'
  element.textContent = name
  element.addEventListener('click', act)
  parent.append(element)
  return element
}
