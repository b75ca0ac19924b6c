import { Tabs, Tooltip } from 'radix-ui';
import { useEffect } from 'react';
import { flushSync } from 'react-dom';
import { useStore } from 'zustand';
import { CanvasView } from '../canvas/index.ts';
import { type Command, listenToKeys, listenToPads } from '../core/commands/index.ts';
import { errorInWords, problemsInWords } from '../core/files/index.ts';
import { openListed } from '../core/levels/index.ts';
import { Button, keepFocus } from '../core/ui/index.ts';
import { AliveStatus } from '../features/alive/index.ts';
import { AttemptsWatch } from '../features/attempts/index.ts';
import { ComparedWatch } from '../features/compare/index.ts';
import { SamplesButton } from '../features/levels/index.ts';
import { PackView, packCommands } from '../features/pack/index.ts';
import { PlayView, playCommands, ReplayView } from '../features/play/index.ts';
import { playsCommands } from '../features/plays/index.ts';
import { SCRIPT_FIELD } from '../features/runs/index.ts';
import { HeatLegend, SolverWatch, solverSessionOf } from '../features/solver/index.ts';
import { Timeline } from '../timeline/index.ts';
import { Dialogs } from './Dialogs.tsx';
import './app.css';
import { type Editor, EditorContext, LevelContext, useEditor, useLevel, useLevelKey, useSession } from '../core/context/index.ts';
import { MendCard } from '../features/mend/index.ts';
import { appCommands } from './app-commands.ts';
import { CheatSheet } from './CheatSheet.tsx';
import { CommandPalette } from './CommandPalette.tsx';
import { HeldBar } from './HeldBar.tsx';
import { Layout, type SidePanel } from './Layout.tsx';
import { NoticeList } from './NoticeList.tsx';
import { LEFT, LEVELS, PROBLEMS, RIGHT } from './parts.tsx';
import { useRoom } from './room.ts';
import { ruleCommands } from './rule-commands.ts';
import { SettingsDialog } from './SettingsDialog.tsx';
import { StatusBar } from './StatusBar.tsx';
import { showPanel } from './show-panel.ts';
import { Toolbar } from './Toolbar.tsx';
import { TopBar } from './TopBar.tsx';
import { useTheme } from './use-theme.ts';

/** The panels of one side, shown one at a time. */
function SideTabs({
  side,
  label,
  panels,
}: {
  readonly side: 'left' | 'right';
  readonly label: string;
  readonly panels: readonly SidePanel[];
}) {
  const { session } = useEditor();
  const shown = useSession((state) => state.panels[side]);
  return (
    <Tabs.Root
      className="panel"
      value={shown}
      onValueChange={(id) => session.setState({ panels: { ...session.getState().panels, [side]: id } })}
    >
      <Tabs.List className="tabs" aria-label={label}>
        {panels.map(({ id, title }) => (
          <Tabs.Trigger key={id} value={id} className="tabs__tab">
            {title}
          </Tabs.Trigger>
        ))}
      </Tabs.List>
      {panels.map(({ id, content }) => (
        <Tabs.Content key={id} value={id} className="panel">
          {content}
        </Tabs.Content>
      ))}
    </Tabs.Root>
  );
}

const ALL_PANELS = [LEVELS, ...LEFT, ...RIGHT, PROBLEMS];

/** Commands that bring a panel to the front. */
function panelCommands(editor: Editor): readonly Command[] {
  const show = (id: string) => showPanel(editor, id);
  return [
    ...ALL_PANELS.map(
      ({ id, title }): Command => ({
        id: `panel.${id}`,
        title: `Show ${title.toLowerCase()}`,
        group: 'View',
        mode: 'both',
        run: () => show(id),
      }),
    ),
    {
      id: 'run.text',
      title: 'Edit the run as text',
      group: 'Run',
      keys: ['t'],
      needs: () => (editor.open.getState()?.proof.proof().run.name == null ? 'show a run first' : null),
      run: () => {
        flushSync(() => show('runs'));
        document.getElementById(SCRIPT_FIELD)?.focus();
      },
    },
    {
      id: 'file.find',
      title: 'Find a level',
      group: 'File',
      keys: ['$mod+p'],
      inText: true,
      run: () => {
        // Where panels are shown one at a time, the list may not be rendered yet.
        flushSync(() => show(LEVELS.id));
        const field = document.querySelector<HTMLInputElement>('.levels input[type="search"]');
        field?.focus();
        field?.select();
      },
    },
  ];
}

function LevelScreen() {
  const editor = useEditor();
  const level = useLevel();
  const key = useLevelKey();
  const mode = useSession((state) => state.mode);
  const { overlay, onion } = solverSessionOf(editor, level);
  const playFrom = useSession((state) => state.playFrom);
  return (
    <>
      <div className="head">
        <TopBar />
        <HeldBar />
      </div>
      <Layout
        left={[LEVELS.content, <SideTabs key="tabs" side="left" label="Objects and runs" panels={LEFT} />]}
        right={[<SideTabs key="tabs" side="right" label="Inspector and tools" panels={RIGHT} />, PROBLEMS.content]}
        canvas={
          <>
            <CanvasView key={key} search={overlay} legend={<HeatLegend />} onion={onion} />
            <Toolbar />
            {mode === 'edit' && (
              <div key={`survival ${key}`} className="survival">
                <AliveStatus />
                <MendCard />
              </div>
            )}
            {mode === 'play' && (typeof playFrom === 'string' ? <PlayView /> : <ReplayView replay={playFrom} />)}
          </>
        }
        timeline={<Timeline key={key} />}
        panels={ALL_PANELS}
      />
      <StatusBar />
      <SolverWatch />
      <AttemptsWatch />
      <ComparedWatch />
    </>
  );
}

/** The page while no level is open. */
function EmptyScreen() {
  const editor = useEditor();
  const { workspace, session } = editor;
  const list = useStore(workspace.store, (state) => state.list);
  const error = useStore(workspace.store, (state) => state.error);
  const refused = useStore(workspace.store, (state) => state.refused);
  const fixedId = list?.levels.find(({ id, status }) => id === refused?.id && status === 'valid')?.id;
  // A refused file opens as soon as it is fixed on disk.
  useEffect(() => {
    if (fixedId !== undefined) void openListed(editor, fixedId);
  }, [editor, fixedId]);
  return (
    <>
      <header className="topbar">
        <h1 className="topbar__level">Gravity Quest editor</h1>
      </header>
      <div className={error === null ? 'start' : 'start start--alone'}>
        {/* Without access to the levels, there is nothing to list and no place for a new level. */}
        {error === null && (
          <aside className="region" aria-label="Levels">
            {LEVELS.content}
          </aside>
        )}
        <main className="empty">
          {error !== null ? (
            <p role="alert">{errorInWords(error)}</p>
          ) : list === null ? (
            <p>Loading levels…</p>
          ) : (
            <p role={refused?.opening.kind === 'invalid' ? 'alert' : undefined}>
              {refused?.opening.kind === 'invalid' &&
                `This level can't be read. ${problemsInWords(`${refused.id}.level.json`, refused.opening.problems)} `}
              {list.levels.length === 0 ? 'No levels here yet.' : 'Choose a level or create a new one.'}
            </p>
          )}
          {error !== null && (
            <Button
              hint="Show unsaved changes that this browser has kept"
              look="outlined"
              onClick={() => session.setState({ overlay: 'kept' })}
            >
              Unsaved changes
            </Button>
          )}
          {error === null && (
            <Button hint="Start from a template" look="main" onClick={() => session.setState({ overlay: 'newLevel' })}>
              New level
            </Button>
          )}
          {error === null && list?.levels.length === 0 && <SamplesButton />}
        </main>
      </div>
      <footer className="statusbar" />
    </>
  );
}

function Screen() {
  const editor = useEditor();
  const level = useStore(editor.open);
  const room = useRoom();
  const isCovered = useSession(({ view }) => view === 'pack');
  useTheme();
  useEffect(() => {
    const { commands, session } = editor;
    const forget = commands.register([
      ...appCommands(editor),
      ...playCommands(editor),
      ...playsCommands(editor),
      ...packCommands(editor),
      ...panelCommands(editor),
      ...ruleCommands(editor),
    ]);
    const mode = () => session.getState().mode;
    const stops = [listenToKeys(window, commands, mode), listenToPads(window, commands, mode), keepFocus(document)];
    return () => {
      forget();
      for (const stop of stops) stop();
    };
  }, [editor]);
  return (
    <div className={`app app--${room}`}>
      {/* what the view of all levels covers can't be used meanwhile */}
      <div className="app__screen" inert={isCovered}>
        {level === null ? (
          <EmptyScreen />
        ) : (
          <LevelContext.Provider value={level}>
            <LevelScreen />
          </LevelContext.Provider>
        )}
      </div>
      <PackView />
      <CommandPalette />
      <CheatSheet />
      <SettingsDialog />
      <Dialogs />
      <NoticeList />
    </div>
  );
}

/** The whole page. */
export function App({ editor }: { readonly editor: Editor }) {
  return (
    <EditorContext.Provider value={editor}>
      <Tooltip.Provider delayDuration={500}>
        <Screen />
      </Tooltip.Provider>
    </EditorContext.Provider>
  );
}
