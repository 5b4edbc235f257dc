// What is shown: the subject, the changed keys, the place of the camera, the moment. All parts of the page follow it.

export const state = {
  subject: null,
  keys: new Map(),     // by their paths
  changes: new Map(),  // path → value as TOML
  place: null,         // {eye, target} where the camera stands freely
  moment: 0,
  live: false,         // the program that serves the page computes what is shown
};

const past = [];
const future = [];
const followers = [];

export function follow(follower) {
  followers.push(follower);
}

export function tell(what) {
  for (const follower of followers) follower(what);
}

const copy = () => ({ changes: new Map(state.changes), place: state.place });

/** Remembers the present, to which undo() goes back. */
export function remember() {
  past.push(copy());
  if (past.length > 200) past.shift();
  future.length = 0;
}

function go(from, to) {
  if (from.length === 0) return;
  to.push(copy());
  Object.assign(state, from.pop());
  tell("changes");
}
export const undo = () => go(past, future);
export const redo = () => go(future, past);
export const canUndo = () => past.length > 0;
export const canRedo = () => future.length > 0;

/** A key's value as TOML. */
export function value(path) {
  return state.changes.get(path) ?? state.keys.get(path)?.value;
}

/** Sets keys; a value that is the subject's own is no change. */
export function set(values) {
  for (const [path, text] of Object.entries(values)) {
    if (text === state.keys.get(path)?.value) state.changes.delete(path);
    else state.changes.set(path, text);
  }
}

export function settings(more = {}) {
  const all = new Map([...state.changes, ...Object.entries(more)]);
  return [...all].map(([path, text]) => `${path}=${text}`);
}

/** What a picture of the present is asked for by. */
export function pictureRequest() {
  return { settings: settings(), moment: state.moment, eye: state.place?.eye ?? null, target: state.place?.target ?? null };
}
