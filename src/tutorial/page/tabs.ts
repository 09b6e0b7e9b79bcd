/** Turns listings that stand one after another, each under its name, into tabs. */
export function tabs(group: HTMLElement): void {
  const panels = [...group.children] as HTMLElement[]
  const list = document.createElement('div')
  list.role = 'tablist'
  list.ariaLabel = 'Language'
  const buttons = panels.map((panel) => {
    const name = panel.querySelector<HTMLElement>('.tab')!
    const button = document.createElement('button')
    button.type = 'button'
    button.role = 'tab'
    button.id = `${panel.id}-tab`
    button.textContent = name.textContent
    button.setAttribute('aria-controls', panel.id)
    panel.role = 'tabpanel'
    panel.setAttribute('aria-labelledby', button.id)
    name.hidden = true
    return button
  })
  const choose = (chosen: number) => {
    buttons.forEach((button, i) => {
      button.ariaSelected = String(i === chosen)
      button.tabIndex = i === chosen ? 0 : -1
      panels[i]!.hidden = i !== chosen
    })
  }
  buttons.forEach((button, i) => {
    button.addEventListener('click', () => choose(i))
    button.addEventListener('keydown', ({ key }) => {
      const step = { ArrowRight: 1, ArrowLeft: -1 }[key]
      if (!step) return
      const next = (i + step + buttons.length) % buttons.length
      choose(next)
      buttons[next]!.focus()
    })
  })
  list.append(...buttons)
  group.prepend(list)
  choose(0)
}
