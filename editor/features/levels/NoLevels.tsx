import { useEditor } from '../../core/context/index.ts';
import { SamplesButton } from '../../core/panel/index.ts';
import { Button } from '../../core/ui/index.ts';

/** The empty state of a folder without levels. @param folder the path as the user gave it */
export function NoLevels({ folder }: { readonly folder: string }) {
  const { session } = useEditor();
  return (
    <div className="levels__empty">
      <p>No levels in {folder} yet.</p>
      <Button hint="Start from a template" look="main" onClick={() => session.setState({ overlay: 'newLevel' })}>
        New level
      </Button>
      <Button hint="From files or from the original game" look="outlined" onClick={() => session.setState({ overlay: 'open' })}>
        Import levels
      </Button>
      <SamplesButton />
    </div>
  );
}
