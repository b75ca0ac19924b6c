import { useEditor } from '../../context/index.ts';
import { Button } from '../../ui/index.ts';
import { SamplesButton } from './SamplesButton.tsx';

/** What to begin with in a folder without levels. @param folder as a person named it */
export function NoLevels({ folder }: { readonly folder: string }) {
  const { session } = useEditor();
  return (
    <div className="levels__empty">
      <p>No levels in {folder} yet.</p>
      <Button hint="Start from a template" look="main" onClick={() => session.setState({ overlay: 'newLevel' })}>
        New level
      </Button>
      <Button hint="From a file, or of the original game" look="outlined" onClick={() => session.setState({ overlay: 'open' })}>
        Import levels
      </Button>
      <SamplesButton />
    </div>
  );
}
