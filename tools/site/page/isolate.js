// Shared memory wants two headers of the page. Where the host sends none, our service worker does;
// it also keeps the site for the next visit, and for one without a network.

const TRIED = "pybgi isolated";

// Whether memory can be shared; the page may be loaded once more on the way to that.
export async function isolate() {
  const workers = navigator.serviceWorker;
  if (!workers) return crossOriginIsolated;
  try {
    await workers.register(new URL("./sw.js", import.meta.url));
    if (crossOriginIsolated) {
      sessionStorage.removeItem(TRIED);
      return true;
    }
    if (sessionStorage.getItem(TRIED)) return false; // in a frame of another site's, say
    sessionStorage.setItem(TRIED, "1");
    await workers.ready;
    if (!workers.controller) {
      await new Promise((resolve) => workers.addEventListener("controllerchange", resolve, { once: true }));
    }
    location.reload();
    return new Promise(() => {}); // the page ends here
  } catch {
    return crossOriginIsolated; // no service worker is allowed here, or nothing kept
  }
}
