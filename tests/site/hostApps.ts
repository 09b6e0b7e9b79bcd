/* The page of the tests of React and Vue, in both. */

/**
 * The same page in both. `window.put` changes what the page knows; `window.known` is what it knows by now, and
 * `window.renders` how often it has rendered itself.
 */
export const apps = {
  React: `
    import { createElement as h, StrictMode, useState } from 'react'
    import { createRoot } from 'react-dom/client'
    import './slide-lab.js'
    window.renders = 0
    function App() {
      const [known, set] = useState(window.start)
      const put = (part) => set((before) => ({ ...before, ...part }))
      Object.assign(window, { known, put })
      window.renders++
      return h('main', null,
        h('h1', null, 'React ', known.time.toFixed(2)),
        known.shown && h('slide-lab', {
          compact: true,
          // A new object each time, as people write it.
          experiment: known.experiment && JSON.parse(JSON.stringify(known.experiment)),
          fps: known.fps,
          onchange: ({ detail }) => put({ experiment: detail.experiments, fps: null }),
          ontimeupdate: ({ detail }) => put({ time: detail.time }),
          onerror: ({ detail }) => put({ error: detail.message }),
        }, h('p', null, 'Blocks on a ramp')),
        known.shown && h('slide-figure', {
          name: known.name,
          values: { ...known.values },
          onchange: ({ detail }) => put({ values: detail }),
          onerror: ({ detail }) => put({ error: detail.message }),
        }, h('p', null, 'A picture'), h('em', { slot: 'caption' }, 'Fig. ', known.time.toFixed(1))),
      )
    }
    createRoot(document.querySelector('#app')).render(h(StrictMode, null, h(App)))`,
  Vue: `
    import { createApp, shallowRef } from 'vue/dist/vue.esm-bundler.js'
    import './slide-lab.js'
    window.renders = 0
    const known = shallowRef(window.start)
    window.known = window.start
    const put = (part) => { window.known = known.value = { ...known.value, ...part } }
    window.put = put
    const app = createApp({
      setup: () => ({ known, put, copy: (value) => value && JSON.parse(JSON.stringify(value)) }),
      beforeUpdate: () => { window.renders++ },
      template: \`<main>
        <h1>Vue {{ known.time.toFixed(2) }}</h1>
        <slide-lab v-if="known.shown" compact :experiment="copy(known.experiment)" :fps="known.fps"
          @change="put({ experiment: $event.detail.experiments, fps: null })"
          @timeupdate="put({ time: $event.detail.time })"
          @error="put({ error: $event.detail.message })"><p>Blocks on a ramp</p></slide-lab>
        <slide-figure v-if="known.shown" :name="known.name" :values="copy(known.values)"
          @change="put({ values: $event.detail })" @error="put({ error: $event.detail.message })"
          ><p>A picture</p><em slot="caption">Fig. {{ known.time.toFixed(1) }}</em></slide-figure>
      </main>\`,
    })
    app.config.compilerOptions.isCustomElement = (tag) => tag.startsWith('slide-')
    app.mount('#app')`,
}

/** What the page knows at first. */
export const start = {
  experiment: { scene: 'ramp', parameters: { angle: 20 } },
  fps: null,
  name: 'area-under-v',
  values: { step: 0.5 },
  shown: true,
  time: 0,
  error: '',
}

/** The same page, written on a server and taken over by the library in the browser, when `window.takeOver` is called. */
export const rendered = {
  React: {
    page: `
      import { createElement as h } from 'react'
      export const page = h('main', null,
        h('slide-lab', { compact: true, fps: '10 60', onchange: () => {} }, h('p', null, 'Blocks')),
        h('slide-figure', { name: 'area-under-v', values: '{"step":0.3}' }, h('em', { slot: 'caption' }, 'Fig. 1')))`,
    server: `
      import { renderToString } from 'react-dom/server'
      import { page } from './page.js'
      process.stdout.write(renderToString(page))`,
    client: `
      import { createElement as h, useEffect } from 'react'
      import { hydrateRoot } from 'react-dom/client'
      import { page } from './page.js'
      const App = () => (useEffect(() => { window.isTaken = true }), page)
      window.takeOver = () => void hydrateRoot(document.querySelector('#app'), h(App))`,
  },
  Vue: {
    page: `
      import { createSSRApp, h } from 'vue'
      export const app = createSSRApp({ render: () => h('main', [
        h('slide-lab', { compact: true, fps: '10 60', onChange: () => {} }, [h('p', 'Blocks')]),
        h('slide-figure', { name: 'area-under-v', values: '{"step":0.3}' }, [h('em', { slot: 'caption' }, 'Fig. 1')])]) })`,
    server: `
      import { renderToString } from 'vue/server-renderer'
      import { app } from './page.js'
      process.stdout.write(await renderToString(app))`,
    client: `
      import { app } from './page.js'
      window.takeOver = () => {
        app.mount('#app')
        window.isTaken = true
      }`,
  },
}
