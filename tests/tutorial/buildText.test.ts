import { beforeAll, describe, expect, test } from 'vitest'
import { highlighter } from '../../src/tutorial/build/highlight.ts'
import type { Highlight } from '../../src/tutorial/build/highlight.ts'
import type { FigureInfo, Materials } from '../../src/tutorial/build/materials.ts'
import { TextError } from '../../src/tutorial/build/problem.ts'
import { tutorialHtml } from '../../src/tutorial/build/tutorial.ts'

let highlight: Highlight

beforeAll(async () => {
  highlight = await highlighter()
})

const ball: FigureInfo = {
  id: 'falling-ball',
  title: 'A falling ball',
  controls: {
    fps: { type: 'number', label: 'Frame rate', from: 5, to: 120, step: 1, initial: 15 },
    method: {
      type: 'choice',
      label: 'Method',
      options: [
        { id: 'per-frame', label: 'per frame' },
        { id: 'variable', label: 'variable' },
      ],
      initial: 'per-frame',
    },
  },
  frame: '--shape-wide: 2',
  still: '<svg></svg>',
}

const source = [
  'before',
  '// #region step',
  '  const a = 1',
  '',
  '    b(a)',
  '// #endregion',
  'after',
]

function build(text: string, others: Partial<Materials> = {}) {
  const materials: Materials = {
    texts: [{ path: 'text/01-what-moves.md', text }],
    facts: { gap: () => '0.42 m' },
    figures: [ball],
    takeHome: [
      { path: 'home/step.ts', text: '// #region all\nlet a = 1\n// #endregion\n' },
      { path: 'home/step3d.ts', text: 'let b = 1\n' },
      { path: 'home/step.cpp', text: 'int a = 1;\n' },
    ],
    read: (path) => (path === 'src/a.ts' ? source.join('\n') : undefined),
    pageIds: ['lab'],
    ...others,
  }
  return tutorialHtml(materials, highlight)
}

/** The HTML of a text without problems, below a title. */
function html(text: string): string {
  const { html: built, problems } = build(`# What moves?\n\n${text}`)
  expect(problems).toEqual([])
  return built
}

/** What is wrong with a text below a title and an empty line. */
function problems(text: string): string[] {
  return build(`# What moves?\n\n${text}`).problems.map(
    ({ line, message }) => `${line}: ${message}`,
  )
}

describe('a heading', () => {
  test('of a file is its section, with number and deep link', () => {
    const built = html('Text.')
    expect(built).toContain('<section id="what-moves">')
    expect(built).toContain(
      '<h2><a href="#what-moves"><span class="numeral">1</span> What moves?</a></h2>',
    )
  })

  test('below it has an id of its words, or its own', () => {
    expect(html('## The mass *cancels*!')).toContain(
      '<h3 id="the-mass-cancels"><a href="#the-mass-cancels">The mass <em>cancels</em>!</a></h3>',
    )
    expect(html('## Long words {#short}')).toContain(
      '<h3 id="short"><a href="#short">Long words</a></h3>',
    )
  })

  test('is in the contents', () => {
    expect(html('Text.')).toMatch(/<nav class="contents"[^]*href="#what-moves"[^]*What moves\?/)
  })

  test('is missing or there twice', () => {
    expect(build('Text.').problems).toEqual([
      { file: 'text/01-what-moves.md', line: 1, message: 'the file has no # title' },
    ])
    expect(problems('# Again')[0]).toMatch(/^3: a second # in one file/)
  })

  test('makes links of dfn and heading collide', () => {
    expect(problems('## Frame\n\nA [frame]{#frame}.')).toEqual([
      '5: the id “frame” is already given in text/01-what-moves.md:3',
    ])
  })
})

describe('words', () => {
  test('in a colour', () => {
    expect(html('[friction *of* it]{.friction}')).toContain(
      '<span class="word friction">friction <em>of</em> it</span>',
    )
    expect(problems('line\n[x]{.frictoin}')).toEqual([
      '4: there is no class “frictoin”: did you mean “friction”?',
    ])
  })

  test('as terms, and links back to them', () => {
    const built = html('A [frame]{#term-frame}. Such [frames](#term-frame).')
    expect(built).toContain('<dfn id="term-frame">frame</dfn>')
    expect(built).toContain('<a href="#term-frame">frames</a>')
    expect(problems('[frames](#term-fame) and [frame]{#term-frame}')).toEqual([
      '3: the link #term-fame leads nowhere: did you mean “term-frame”?',
    ])
  })

  test('in brackets without braces stay as they are', () => {
    expect(html('[0, 1] and [x] {y}')).toContain('<p>[0, 1] and [x] {y}</p>')
  })

  test('may not be HTML', () => {
    expect(html('<script>x</script>')).toContain('&lt;script&gt;')
  })
})

describe('numbers', () => {
  test('from the facts', () => {
    expect(html('It is {{gap}} off.')).toContain('<p>It is 0.42 m off.</p>')
    expect(problems('{{gab}}')).toEqual(['3: there is no fact “gab”: did you mean “gap”?'])
    expect(problems('{{toString}}')[0]).toContain('there is no fact “toString”')
  })

  test('to drag, with what the control allows', () => {
    expect(
      html('At {{falling-ball.fps=15 frames a second}}.\n\n```figure falling-ball\nBall.\n```'),
    ).toContain(
      'At <span class="dial" data-figure="falling-ball" data-control="fps"' +
        ' data-label="Frame rate in the figure “A falling ball”"' +
        ' data-min="5" data-max="120" data-step="1">15</span>\u00a0frames a second.',
    )
  })

  test.each([
    ['{{falling-ball.fps=16}}', 'the figure “falling-ball” opens with fps = 15, not 16'],
    ['{{falling-ball.fpz=15}}', 'has no control “fpz”: did you mean “fps”?'],
    ['{{falling-ball.fps=1000}}', 'fps of the figure “falling-ball” can’t be 1000'],
    ['{{falling-ball.method=variable}}', 'is no number'],
    ['{{faling-ball.fps=15}}', 'there is no figure “faling-ball”: did you mean “falling-ball”?'],
  ])('%s is refused', (text, message) => {
    expect(problems(text).join('\n')).toContain(message)
  })
})

test('a formula keeps its comma', () => {
  expect(html('With $x$, and $y$ too.')).toMatch(
    /With <span class="together"><math>.*?<\/math>,<\/span> and <math>.*?<\/math> too\./,
  )
})

describe('links', () => {
  const figure = '\n\n```figure falling-ball\nBall.\n```'

  test('set a figure', () => {
    expect(html(`[At 30](set:falling-ball?fps=30&method=variable)${figure}`)).toContain(
      '<a href="#figure-falling-ball" data-set="falling-ball?fps=30&amp;method=variable">At 30</a>',
    )
  })

  test.each([
    ['set:falling-ball', 'sets nothing'],
    ['set:falling-ball?fps=4', 'can’t be 4: the nearest that it can is 5'],
    ['set:falling-ball?fps=30.5', 'can’t be 30.5'],
    ['set:falling-ball?method=varable', 'did you mean “variable”?'],
    ['set:falling-ball?speed=1', 'has no control “speed”'],
    ['set:ball?fps=5', 'there is no figure “ball”'],
  ])('to %s are refused', (href, message) => {
    expect(problems(`[x](${href})${figure}`).join('\n')).toContain(message)
  })

  test('to a figure that is not in the text lead nowhere', () => {
    expect(problems('[x](set:falling-ball?fps=30)')).toEqual([
      expect.stringContaining('3: the link #figure-falling-ball leads nowhere'),
    ])
  })

  test('open an experiment in the lab', () => {
    expect(html('[x](lab:?scene=half-pipe&runners=30;60/rk4)')).toContain(
      '<a href="#scene=half-pipe&amp;runners=30;60/rk4" data-lab="">x</a>',
    )
    expect(problems('[x](lab:?scene=moon)')[0]).toMatch(
      /^3: lab:\?scene=moon can’t be opened: scene/,
    )
  })

  test('lead out, and nowhere else', () => {
    expect(html('[x](https://example.org/a)')).toContain('<a href="https://example.org/a">x</a>')
    expect(html('[x](#lab)')).toContain('<a href="#lab">x</a>')
    expect(problems('[x](other.md)')[0]).toContain('“other.md” is no link')
    expect(problems('a\nb [x](#nowhere)')[0]).toMatch(/^4: the link #nowhere leads nowhere/)
  })
})

describe('a figure', () => {
  test('has its still, its room, its number and a caption in markdown', () => {
    const built = html('```figure falling-ball\nThe [gap]{.sum} is {{gap}}.\n```')
    expect(built).toContain(
      '<figure class="figure" id="figure-falling-ball"><slide-figure name="falling-ball" style="--shape-wide: 2"><svg></svg></slide-figure>',
    )
    expect(built).toContain(
      '<figcaption><p><span class="figure-number"><a href="#figure-falling-ball">Figure 1</a>.</span> The <span class="word sum">gap</span> is 0.42 m.</p></figcaption>',
    )
  })

  test('is refused without a caption, twice, or unknown', () => {
    expect(problems('```figure falling-ball\n```')).toEqual([
      '3: the figure “falling-ball” has no caption',
    ])
    const twice = '```figure falling-ball\nx\n```\n'
    expect(problems(twice + twice)[0]).toContain('6: the id “figure-falling-ball” is already given')
    expect(problems('```figure ball\nx\n```')[0]).toContain('there is no figure “ball”')
  })

  test('tells the line of what is wrong in its caption', () => {
    expect(problems('```figure falling-ball\nWords.\nMore {{gab}}.\n```')[0]).toMatch(/^5: /)
  })
})

describe('code', () => {
  test('by region: without its marks, at the left edge, with its path', () => {
    const built = html('```source src/a.ts#step\nThe *step*.\n```')
    expect(built).toContain('<figure class="code"><pre data-label="From src/a.ts">')
    expect(lines(built)).toEqual(['const a = 1', '', '  b(a)'])
    expect(built).toContain(
      '<figcaption><code>src/<wbr>a.ts</code> <div><p>The <em>step</em>.</p></div>',
    )
  })

  test('is coloured by what its pieces are', () => {
    expect(html('```ts\nconst a = 1 // why\n```')).toContain(
      '<span class="line"><span class="keyword">const </span><span class="number">a </span>= ',
    )
  })

  test('has the names of forces in their colours', () => {
    expect(html('```ts\nconst friction = times(2, normal)\n```')).toMatch(
      /<span class="friction">friction ?<\/span>.*<span class="normal">normal<\/span>/,
    )
  })

  test.each([
    ['source src/b.ts#step', 'there is no file src/b.ts'],
    ['source src/a.ts#stop', 'src/a.ts has no region “stop”: did you mean “step”?'],
    ['figur falling-ball', '“figur” is no kind of block: did you mean “figure”?'],
  ])('%s is refused', (info, message) => {
    expect(problems(`\`\`\`${info}\n\`\`\``)).toEqual([`3: ${message}`])
  })

  test('to take home comes in all its languages, those of two dimensions first', () => {
    const built = html('```take-home\n```')
    expect(built).toContain('<p class="tab">TypeScript, 2D</p>')
    expect(built).toContain('<p class="tab">C++ (Unreal), 2D</p>')
    expect(built).toContain('id="take-home-ts-3d"')
    expect(lines(built)).toEqual(['let a = 1', 'int a = 1;', 'let b = 1'])
  })

  function lines(built: string): string[] {
    return [...built.matchAll(/<span class="line">(.*)<\/span>(?=\n|<\/code>)/g)].map((match) =>
      match[1]!.replace(/<[^>]+>/g, ''),
    )
  }
})

test('a table can be scrolled', () => {
  expect(html('| a | b |\n|---|---|\n| 1 | 2 |')).toMatch(
    /<div class="table" data-label="Table"><table>[^]*<\/table><\/div>/,
  )
})

test('an error names every place', () => {
  const error = new TextError(build('# A\n\n{{x}}\n\n[y](#z)').problems)
  expect(error.message.split('\n')).toEqual([
    'The tutorial can’t be built:',
    '  text/01-what-moves.md:3  there is no fact “x”: there is gap',
    expect.stringContaining('  text/01-what-moves.md:5  the link #z leads nowhere') as string,
  ])
  expect(error.stack).toBe(error.message)
})
